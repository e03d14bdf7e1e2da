#pragma once

#include "splitsum/math/vec.h"
#include "splitsum/sphere/cubemap.h"

namespace splitsum {

/// What a seamless bilinear lookup towards `direction` (any length but 0) returns: the four texels
/// around it, those beyond an edge taken from the neighbouring face; at a corner, where only three
/// meet, the fourth is their mean (Vulkan 1.3, 16.5.4 "Cube Map Edge Handling").
Vec3 bilinear_lookup(const Cubemap& cubemap, const Vec3d& direction);

}  // namespace splitsum
