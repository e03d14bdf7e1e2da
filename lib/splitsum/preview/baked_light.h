#pragma once

#include <vector>

#include "splitsum/image/table.h"
#include "splitsum/math/vec.h"
#include "splitsum/plan/roughness_curve.h"
#include "splitsum/preview/camera.h"
#include "splitsum/shading/material.h"
#include "splitsum/sphere/cubemap.h"

namespace splitsum {

/// Baked assets as an engine holds them: texels as they were stored, decoded.
struct BakedLight {
    std::vector<Cubemap> specular;  ///< level 0 is the mirror image
    RoughnessCurve curve;           ///< of the levels
    Cubemap irradiance;             ///< E / pi by normal
    Table split_sum;                ///< (a, b), in the arrangement look_up() reads
};

/// Radiance towards the viewer of a surface under the baked light, as
/// shaders/runtime/image_based_light.frag computes it: trilinear lookups towards the mirror
/// direction, times the reflectance of all bounces, and diffuse light of what lies below.
/// `normal` and `view` are unit vectors in the cube's axes.
Vec3d shade(const BakedLight& light, const Material& material, const Vec3d& normal,
            const Vec3d& view);

}  // namespace splitsum
