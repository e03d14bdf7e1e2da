#pragma once

#include "splitsum/math/vec.h"
#include "splitsum/sphere/cubemap.h"

namespace splitsum {

/// What a seamless bilinear lookup towards `direction` (any length but 0) returns: the four texels
/// around it, those beyond an edge taken from the neighbouring face.
Vec3 bilinear_lookup(const Cubemap& cubemap, const Vec3d& direction);

}  // namespace splitsum
