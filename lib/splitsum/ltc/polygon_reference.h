#pragma once

#include <span>

#include "splitsum/ltc/target_lobe.h"

namespace splitsum {

/// The radiance that a lobe itself reflects from a convex polygonal light of radiance 1 (for GGX: of
/// reflectance 1): the judge of transformed cosines. `polygon` as in polygon_light.h, but clipped by
/// the horizon of the surface.
///
/// The sphere is stretched until the lobe is of ordinary width, the polygon cut by the faces of a cube
/// there, and its triangles halved until two Gauss rules agree to `tolerance` (absolute, of each
/// piece). Tested against the whole sky and a plain sum. Cost: about 0.2 ms.
double polygon_light_reference(const TargetLobe& lobe, std::span<const Vec3d> polygon,
                               double tolerance = 1e-6);

}  // namespace splitsum
