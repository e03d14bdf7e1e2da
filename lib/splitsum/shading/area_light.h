#pragma once

#include <array>

#include "splitsum/ltc/transformed_cosine.h"
#include "splitsum/math/vec.h"

namespace splitsum {

// Flat lights with four corners, shaded by the tables `ltc-ggx` and `ltc-disney`: the twin of
// shaders/include/splitsum_area_light.glsl. How the tables are read: table/ltc_lookup.h.

/// Four corners of a convex flat light, in order, seen from the shaded point: corner minus point, in
/// world axes. A triangle has its last corner twice. The lit side is the one that
/// cross(corner 1 - corner 0, corner 3 - corner 0) points to.
using LightCorners = std::array<Vec3d, 4>;

/// Carries world directions into the frame of transformed_cosine.h: +z the normal, +x the viewer's
/// side. Unit vectors. Where the viewer looks along the normal, less than 1e-6 off, any side will do.
Mat3d light_frame(const Vec3d& normal, const Vec3d& view);

/// What a lobe gathers from the light, as a share of its radiance, in [0, 1]: ltc_polygon_light, and
/// 0 behind a light with one side. Times ltc_reflectance and the light's radiance it is the radiance
/// towards the viewer; with the default LtcInverse, times an albedo, the diffuse one.
double area_light(const LtcInverse& inverse, const Mat3d& frame, const LightCorners& corners,
                  bool two_sided);

}  // namespace splitsum
