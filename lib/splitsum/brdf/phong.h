#pragma once

#include "splitsum/math/vec.h"

namespace splitsum {

// Two lobes about the mirror direction that differ in what a renderer can rely on; an example, not
// used by any filter. Unit vectors with +z along the normal; both are 0 below the horizon.

/// Phong 1975, "Illumination for Computer Generated Pictures", as the BRDF that it implies: light is
/// not weighted with n·l, so
///     f(l, v) = cos(angle between l and the mirror image of v)^exponent / n·l.
/// Neither reciprocal nor bounded: it returns up to 2 pi / (exponent + 1) times what it gets.
double phong_brdf(const Vec3d& light, const Vec3d& view, double exponent);

/// Lewis 1994, "Making Shaders More Physically Plausible"; Lafortune & Willems 1994, "Using the
/// Modified Phong Reflectance Model for Physically Based Rendering":
///     f(l, v) = (exponent + 2) / (2 pi) cos(angle between l and the mirror image of v)^exponent.
/// Reciprocal, and its directional albedo is at most 1, which it reaches at the normal.
double normalised_phong_brdf(const Vec3d& light, const Vec3d& view, double exponent);

}  // namespace splitsum
