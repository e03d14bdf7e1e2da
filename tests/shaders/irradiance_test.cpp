#include <gtest/gtest.h>

#include "shaders/twins.h"
#include "splitsum/base/text.h"
#include "splitsum/filter/irradiance_harmonics.h"
#include "splitsum/math/harmonics.h"

namespace splitsum::tests {
namespace {

const std::vector<Float4> normals =
    items(5000, [](uint32_t i) { return float4(random_direction(i)); });

// Coefficients of either sign and no order: every harmonic shows in the sum.
IrradianceHarmonics random_harmonics(int order) {
    IrradianceHarmonics harmonics;
    harmonics.order = order;
    for (uint32_t i = 0; i < harmonic_count(order); ++i)
        harmonics.coefficients.emplace_back(between(-1, 1, 3 * i), between(-1, 1, 3 * i + 1),
                                            between(-1, 1, 3 * i + 2));
    return harmonics;
}

TEST(IrradianceGlsl, SumsTheHarmonicsOfEveryOrder) {
    for (const int order : {2, 3, 4}) {
        const IrradianceHarmonics harmonics = random_harmonics(order);
        std::vector<float> block;
        for (const Vec3d& c : harmonics.coefficients)
            block.insert(block.end(), {float(c.x), float(c.y), float(c.z), 0.0F});
        expect_twin({.includes = {"irradiance"},
                     .body = cat("answer.xyz = splitsum_irradiance_of_order_", order,
                                 "(asked(0).xyz, harmonics);"),
                     .inputs = {normals},
                     .declarations = cat("layout(std140) uniform Harmonics { vec3 harmonics[",
                                         harmonic_count(order), "]; };"),
                     .set_up = [&](Program& program) { program.set_block("Harmonics", block); }},
                    few_roundings, [&](size_t i) {
                        return answer_of(evaluate(harmonics, normalize(vec3d(normals[i]))));
                    });
    }
}

}  // namespace
}  // namespace splitsum::tests
