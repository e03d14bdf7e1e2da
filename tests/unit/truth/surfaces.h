#pragma once

#include <cmath>

#include "splitsum/truth/surface.h"

namespace splitsum::tests {

/// A surface whose normal lies on no axis, seen at this cosine.
inline Surface lopsided_surface(const Material& material, double n_dot_v) {
    const Vec3d normal(0.36, 0.48, -0.8);
    const Vec3d across = normalize(cross(normal, Vec3d(0.3, 0.9, 0.1)));
    const Vec3d view = n_dot_v * normal + std::sqrt((1 - n_dot_v) * (1 + n_dot_v)) * across;
    return surface_of(material, ViewSplitSum(alpha_of(material)), normal, view);
}

}  // namespace splitsum::tests
