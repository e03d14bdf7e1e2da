#pragma once

#include "splitsum/sphere/environment.h"

namespace splitsum {

// Panoramas that some way of filtering finds hard, `rows` high. None has a symmetry that would hide
// mirrored or swapped axes, but the constant.

/// Red grows along +x, green along +y, blue along +z. Smooth; radiance 0.2 to 2.2.
Environment gradient_sky(int rows);

/// Dim even sky (0.1, 0.2, 0.3) with one texel of `radiance` (times 1, 0.7, 0.3) off every axis,
/// towards a texel centre of cubemaps of 8 x 8 texels a face.
Environment sun_sky(int rows, float radiance);

/// The same with a second sun of a tenth, bluer, on another face and below the horizon.
Environment two_suns_sky(int rows);

/// A sun of 1e5 in one texel of the top row, where texels are smallest.
Environment sun_at_pole_sky(int rows);

/// The gradient with both rows of the poles lit by 100.
Environment lit_poles_sky(int rows);

/// The gradient with the column lit by 100 that runs along the edge between faces +X and +Z.
Environment lit_edge_sky(int rows);

/// Warm and dark texels in turn: all there is lies at the highest frequency.
Environment checkerboard_sky(int rows);

/// Black but for one texel of 1.
Environment one_texel_sky(int rows);

/// (0.7, 3, 1e4) everywhere.
Environment constant_sky(int rows);

/// A dark gradient with 40 coloured lamps of one texel each, radiance 10 to 2000, most of them below
/// the horizon. Places and colours come from hashes of the lamp's number.
Environment night_sky(int rows);

/// The dim sky of sun_sky with three texels beyond every format but 32-bit floats: up to 3e5.
Environment overflowing_sky(int rows);

}  // namespace splitsum
