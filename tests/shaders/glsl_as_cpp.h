#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

/// The shader includes, compiled as C++: GLM has GLSL's vectors, this file the few functions that
/// take GLSL's literals, which are doubles to C++.
namespace splitsum::tests::glsl {

using glm::mat3;
using glm::vec2;
using glm::vec3;
using glm::vec4;

inline float clamp(float x, double low, double high) {
    return std::clamp(x, static_cast<float>(low), static_cast<float>(high));
}
inline float max(float x, double y) { return std::max(x, static_cast<float>(y)); }
inline float max(double x, double y) { return static_cast<float>(std::max(x, y)); }
inline float sqrt(double x) { return std::sqrt(static_cast<float>(x)); }

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wfloat-conversion"
#include "splitsum_area_light.glsl"
#include "splitsum_cloth.glsl"
#include "splitsum_levels.glsl"
#include "splitsum_split_sum.glsl"
#pragma GCC diagnostic pop

}  // namespace splitsum::tests::glsl
