#pragma once

#include <string>

#include "splitsum/sphere/cubemap.h"
#include "splitsum/sphere/environment.h"

namespace splitsum {

// Small pictures for a page: PNG files as bytes. Light L is shown as e L / (1 + e L) (Reinhard et
// al. 2002, eq. 3), sRGB-encoded; what is no light (NaN, infinite, negative) is magenta.

/// A panorama at its own resolution, at most 128 texels wide, exposed for itself.
std::string picture_of(const Environment& environment);

/// The factor e that brings the logarithmic mean of the light to 0.25. 1 for a black cubemap.
float exposure_of(const Cubemap& cubemap);

/// A cubemap as a lat-long strip of 32 x 16 texels.
std::string picture_of(const Cubemap& cubemap, float exposure);

}  // namespace splitsum
