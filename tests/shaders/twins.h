#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "shaders/program.h"
#include "splitsum/base/random.h"

namespace splitsum::tests {

/// Up to four numbers that a shader and its twin answer with.
using Answer = std::array<double, 4>;

/// One question to the shader library, asked for every item of the inputs.
struct Question {
    std::vector<std::string> includes;        ///< "levels" for splitsum_levels.glsl
    std::string body;                         ///< assigns `answer`; asked(k) is input k of the item
    std::vector<std::vector<Float4>> inputs;  ///< input k of every item, all equally many
    std::string declarations = {};            ///< uniforms
    std::function<void(Program&)> set_up = {};  ///< textures and blocks
};

/// What the shader says to every item.
std::vector<Float4> answers_of_shader(Language language, const Question& question);

/// Where a shader and its twin differ most. The difference is absolute for numbers up to 1 and relative
/// above; NaN is the worst.
struct Worst {
    double difference = 0;
    std::string where;
};
Worst worst_difference(const std::vector<Float4>& answers,
                       const std::function<Answer(size_t item)>& twin);

/// The limit where no digits cancel. Measured: 4e-7 at most.
inline constexpr double few_roundings = 2e-6;

/// Runs the shader in both languages and compares with the twin at every item.
void expect_twin(const Question& question, double limit,
                 const std::function<Answer(size_t item)>& twin);

/// The text of a file in build/shaders.
std::string built_shader(const std::string& path);

/// Numbers from keys, inputs of a test.
inline float between(float low, float high, uint32_t key) {
    return low + (high - low) * unit_float(key);
}

/// A unit vector, evenly over the sphere.
Vec3 random_direction(uint32_t key);

inline Float4 float4(const Vec3& v, float w = 0) { return {v.x, v.y, v.z, w}; }
inline Vec3d vec3d(const Float4& v) {
    return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}
inline Answer answer_of(const Vec3d& v, double w = 0) { return {v.x, v.y, v.z, w}; }

/// `count` items, each from its key.
template <class Make>
std::vector<Float4> items(size_t count, const Make& make) {
    std::vector<Float4> made(count);
    for (size_t i = 0; i < count; ++i) made[i] = make(static_cast<uint32_t>(i));
    return made;
}

}  // namespace splitsum::tests
