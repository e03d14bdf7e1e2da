#pragma once

#include <algorithm>

#include "splitsum/math/vec.h"

namespace splitsum {

// How the tables of an albedo are used. Cloth: the twin of shaders/include/splitsum_cloth.glsl.

/// The share of uniform light that cloth of this colour reflects.
inline Vec3d cloth_reflectance(const Vec3d& sheen_color, double cloth_albedo) {
    return cloth_albedo * sheen_color;
}

/// What layers below cloth are multiplied with, so that both return no more than comes in: the
/// brightest channel decides (KHR_materials_sheen, "Albedo scaling technique"). In [0, 1].
inline double below_cloth(const Vec3d& sheen_color, double cloth_albedo) {
    const double brightest = std::max({sheen_color.x, sheen_color.y, sheen_color.z});
    return std::clamp(1 - brightest * cloth_albedo, 0.0, 1.0);
}

// Diffuse lobes: the twin of shaders/include/splitsum_diffuse.glsl.

/// The share of uniform light that a diffuse surface of this colour reflects, and what the irradiance
/// E / pi is multiplied with.
inline Vec3d diffuse_reflectance(const Vec3d& base_color, double diffuse_albedo) {
    return diffuse_albedo * base_color;
}

/// The same with the albedo of a white surface at most 1: no more comes back than came in.
inline Vec3d diffuse_reflectance_bounded(const Vec3d& base_color, double diffuse_albedo) {
    return std::min(diffuse_albedo, 1.0) * base_color;
}

}  // namespace splitsum
