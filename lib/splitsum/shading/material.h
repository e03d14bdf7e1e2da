#pragma once

#include "splitsum/math/vec.h"

namespace splitsum {

/// A surface as glTF 2.0 describes it (appendix B, metallic-roughness). All in [0, 1].
struct Material {
    Vec3d base_color{1};  ///< scene-linear
    double metalness = 0;
    double perceptual_roughness = 0.5;
};

}  // namespace splitsum
