#include "splitsum/shading/directions.h"

#include <gtest/gtest.h>

#include "shaders/twins.h"

namespace splitsum::tests {
namespace {

const std::vector<Float4> directions_and_turns =
    items(5000, [](uint32_t i) { return float4(random_direction(i), between(-7, 7, 90'000 + i)); });

void expect_axes(const std::string& function, WorldAxes axes) {
    expect_twin({.includes = {"directions"},
                 .body = "answer.xyz = " + function + "(asked(0).xyz);",
                 .inputs = {directions_and_turns}},
                0, [&](size_t i) {
                    return answer_of(cube_from_world(axes, vec3d(directions_and_turns[i])));
                });
}

TEST(DirectionsGlsl, ChangesAxesExactly) {
    expect_axes("splitsum_cube_from_left_handed", WorldAxes::left_handed);
    expect_axes("splitsum_cube_from_right_handed", WorldAxes::right_handed);
    expect_axes("splitsum_cube_from_three", WorldAxes::three);
}

TEST(DirectionsGlsl, TurnsTheEnvironment) {
    expect_twin(
        {.includes = {"directions"},
         .body = "answer.xyz = splitsum_turned_environment(asked(0).xyz, asked(0).w);",
         .inputs = {directions_and_turns}},
        few_roundings, [](size_t i) {
            const Float4& asked = directions_and_turns[i];
            return answer_of(turned_environment(vec3d(asked), static_cast<double>(asked[3])));
        });
}

}  // namespace
}  // namespace splitsum::tests
