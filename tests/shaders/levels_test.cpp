#include <gtest/gtest.h>

#include <algorithm>

#include "shaders/twins.h"
#include "splitsum/base/text.h"
#include "splitsum/plan/roughness_curve.h"

namespace splitsum::tests {
namespace {

// Roughness, beyond [0, 1] so that clamping is part of the comparison.
const std::vector<Float4> roughness = items(5000, [](uint32_t i) {
    return Float4{between(-0.1F, 1.1F, i), 0, 0, 0};
});

double roughness_of(size_t i) { return static_cast<double>(roughness[i][0]); }

// The square root of what is left to roughness 1 has half of the digits there. Measured: 5e-5.
void expect_curve(const std::string& name, RoughnessCurve::Kind kind) {
    const RoughnessCurve curve{kind, {}};
    for (const int levels : {1, 2, 7, 14}) {
        const std::string last = cat("float(", levels - 1, ")");
        expect_twin({.includes = {"levels"},
                     .body = cat("float level = splitsum_level_", name, "(asked(0).x, ", last,
                                 ");\n", "answer.x = level; answer.y = splitsum_roughness_", name,
                                 "(level, ", last, ");\nanswer.z = splitsum_roughness_", name,
                                 "(float(int(gl_FragCoord.x) % ", levels, "), ", last, ");"),
                     .inputs = {roughness}},
                    2e-4, [&](size_t i) {
                        const double r = std::clamp(roughness_of(i), 0.0, 1.0);
                        const auto of_levels = roughness_of_levels(curve, levels);
                        return Answer{level_of_roughness(curve, levels, roughness_of(i)),
                                      levels > 1 ? r : 0.0, of_levels[i % 64 % size_t(levels)], 0};
                    });
    }
}

TEST(LevelsGlsl, FindsLevelsAndTheirRoughness) {
    expect_curve("linear", RoughnessCurve::Kind::linear);
    expect_curve("filament", RoughnessCurve::Kind::filament);
}

// Lists of 1 to 16 values, which may begin above 0, end below 1 and repeat themselves.
TEST(LevelsGlsl, FindsTheLevelsOfLists) {
    const std::vector<std::vector<double>> lists = {
        {0.5},
        {0, 1},
        {0.0625, 0.25, 0.25, 0.75},
        {0, 0.125, 0.125, 0.5, 0.875, 1, 1},
        {0, 0.01, 0.02, 0.04, 0.08, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1}};
    for (const auto& list : lists) {
        const RoughnessCurve curve{RoughnessCurve::Kind::list, list};
        ASSERT_TRUE(validate(curve));
        std::vector<float> block(16, 0.0F);
        std::ranges::transform(list, block.begin(), [](double r) { return static_cast<float>(r); });
        const auto levels = static_cast<int>(list.size());
        expect_twin(
            {.includes = {"levels"},
             .body = cat("answer.x = splitsum_level_of_list(asked(0).x, list, ", levels, ");"),
             .inputs = {roughness},
             .declarations = "layout(std140) uniform List { vec4 list[4]; };",
             .set_up = [&](Program& program) { program.set_block("List", block); }},
            few_roundings, [&](size_t i) {
                return Answer{level_of_roughness(curve, levels, roughness_of(i)), 0, 0, 0};
            });
    }
}

}  // namespace
}  // namespace splitsum::tests
