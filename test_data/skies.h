#pragma once

#include <functional>

#include "splitsum/image/image.h"
#include "splitsum/math/vec.h"

namespace splitsum::test_data {

/// Radiance that arrives from a unit direction: +y up, +z in the middle of the panorama, +x to the
/// right of it.
using Sky = std::function<Vec3d(const Vec3d& direction)>;

/// A lat-long panorama of `2 * height` by `height` texels; each is the mean of `sub` by `sub`
/// directions spread evenly over it.
Image panorama_of(const Sky& sky, int height, int sub);

/// Red grows along +x, green along +y, blue along +z, with a soft sun off every axis: no mirrored or
/// swapped axis leaves it alone.
Vec3d lopsided_sky(const Vec3d& direction);

/// A clear gradient. sun_panorama() puts the sun.
Vec3d gradient_sky(const Vec3d& direction);

/// The gradient with a sun of 2 by 2 texels, 1e5 bright: above what half floats hold.
Image sun_panorama(int height);

/// Black, but for one texel.
Image one_texel_panorama(int height);

/// Three polygonal lights in a nearly black room.
Vec3d studio_sky(const Vec3d& direction);

/// A dark sky over a street of small coloured lamps.
Vec3d night_sky(const Vec3d& direction);

/// A low sun behind thin clouds over the sea.
Vec3d sunset_sky(const Vec3d& direction);

}  // namespace splitsum::test_data
