#include <gtest/gtest.h>

#include "shaders/twins.h"
#include "splitsum/table/albedo_lookup.h"

namespace splitsum::tests {
namespace {

const std::vector<Float4> colors = items(5000, [](uint32_t i) {
    return Float4{unit_float(4 * i), unit_float(4 * i + 1), unit_float(4 * i + 2),
                  unit_float(4 * i + 3)};
});

// Cloth seen edge on returns more than it gets: albedos up to 4.
TEST(ClothGlsl, ReflectsAndLeavesTheRest) {
    expect_twin({.includes = {"cloth"},
                 .body = "float albedo = 4.0 * asked(0).w;\n"
                         "answer.xyz = splitsum_cloth_reflectance(asked(0).xyz, albedo);\n"
                         "answer.w = splitsum_below_cloth(asked(0).xyz, albedo);",
                 .inputs = {colors}},
                few_roundings, [](size_t i) {
                    const double albedo = 4 * static_cast<double>(colors[i][3]);
                    return answer_of(cloth_reflectance(vec3d(colors[i]), albedo),
                                     below_cloth(vec3d(colors[i]), albedo));
                });
}

}  // namespace
}  // namespace splitsum::tests
