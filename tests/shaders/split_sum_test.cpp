#include <gtest/gtest.h>

#include <algorithm>

#include "shaders/twins.h"
#include "splitsum/base/text.h"
#include "splitsum/table/bilinear.h"
#include "splitsum/table/split_sum_fit.h"
#include "splitsum/table/split_sum_lookup.h"

namespace splitsum::tests {
namespace {

constexpr size_t count = 5000;

// n·v and roughness, beyond [0, 1].
const std::vector<Float4> coordinates = items(count, [](uint32_t i) {
    return Float4{between(-0.1F, 1.1F, 2 * i), between(-0.1F, 1.1F, 2 * i + 1), 0, 0};
});

double view_of(size_t i) { return static_cast<double>(coordinates[i][0]); }
double roughness_of(size_t i) { return static_cast<double>(coordinates[i][1]); }

const std::vector<Float4> reflectances = items(count, [](uint32_t i) {
    return Float4{unit_float(3 * i), unit_float(3 * i + 1), unit_float(3 * i + 2), 0};
});

// a in [0.01, 0.8), b in [0, 0.2).
const std::vector<Float4> split_sums = items(count, [](uint32_t i) {
    return Float4{between(0.01F, 0.8F, 70'000 + 2 * i), between(0, 0.2F, 70'001 + 2 * i), 0, 0};
});

SplitSum split_sum_of(size_t i) {
    return {static_cast<double>(split_sums[i][0]), static_cast<double>(split_sums[i][1])};
}

// Compares a function of F0 and (a, b), channel by channel.
void expect_of_f0(const std::string& call, double (*twin)(const SplitSum&, double)) {
    expect_twin(
        {.includes = {"split_sum"},
         .body = cat("vec2 ab = asked(1).xy; vec2 multiscatter = vec2(ab.y, ab.x + ab.y);\n",
                     "answer.xyz = ", call, ";"),
         .inputs = {reflectances, split_sums}},
        few_roundings, [&](size_t i) {
            const Vec3d f0 = vec3d(reflectances[i]);
            const SplitSum sum = split_sum_of(i);
            return Answer{twin(sum, f0.x), twin(sum, f0.y), twin(sum, f0.z), 0};
        });
}

TEST(SplitSumGlsl, UsesWhatTheTableHolds) {
    expect_of_f0("splitsum_directional_albedo(asked(0).xyz, ab)", directional_albedo);
    expect_of_f0("splitsum_energy_compensation(asked(0).xyz, ab)", energy_compensation);
    expect_of_f0("splitsum_reflectance(asked(0).xyz, ab)", reflectance);
    expect_of_f0("splitsum_directional_albedo_of_multiscatter(asked(0).xyz, multiscatter)",
                 directional_albedo);
    expect_of_f0("splitsum_energy_compensation_of_multiscatter(asked(0).xyz, multiscatter)",
                 energy_compensation);
}

TEST(SplitSumGlsl, ScattersBetweenFacets) {
    const auto energies = items(count, [](uint32_t i) {
        return Float4{unit_float(3 * i), unit_float(3 * i + 1),
                      i % 7 == 0 ? 1.0F : unit_float(3 * i + 2), 0};
    });
    expect_twin({.includes = {"split_sum"},
                 .body = "vec3 e = asked(0).xyz;\n"
                         "answer.x = splitsum_multiple_scattering(e.x, e.y, e.z);\n"
                         "answer.y = splitsum_multiple_scattering_of_lost(e.x, e.y, 0.5 * e.z);",
                 .inputs = {energies}},
                few_roundings, [&](size_t i) {
                    const Vec3d e = vec3d(energies[i]);
                    return Answer{multiple_scattering(e.x, e.y, e.z),
                                  multiple_scattering_of_lost(e.x, e.y, 0.5 * e.z), 0, 0};
                });
}

TEST(SplitSumGlsl, FindsTexelsInBothLayouts) {
    for (const int size : {2, 17, 64}) {
        const auto placed = [&](size_t i, TexelLayout layout) {
            TablePlan plan;
            plan.layout = layout;
            return texture_coordinates(plan, size, ViewAxis::cosine, view_of(i), roughness_of(i));
        };
        expect_twin({.includes = {"split_sum"},
                     .body = cat("vec2 at = splitsum_table_coordinates(asked(0).x, asked(0).y);\n",
                                 "answer.xy = at;\n",
                                 "answer.zw = splitsum_edge_coordinates(at, float(", size, "));"),
                     .inputs = {coordinates}},
                    1e-6, [&](size_t i) {
                        const Vec2d centre = placed(i, TexelLayout::centre);
                        const Vec2d edge = placed(i, TexelLayout::edge);
                        return Answer{centre.x, centre.y, edge.x, edge.y};
                    });
    }
}

// Its terms are up to a hundred times as large as the sum. Measured: 1.3e-5.
TEST(SplitSumGlsl, EvaluatesTheClosedForm) {
    const SmithTerm term = SmithTerm::height_correlated;
    expect_twin({.includes = {"ggx_fit"},
                 .body = "answer.xy = splitsum_ggx_fit(asked(0).x, asked(0).y);",
                 .inputs = {coordinates}},
                5e-5, [&](size_t i) {
                    const SplitSum sum =
                        evaluate(shipped_fit(term), term, std::clamp(view_of(i), 0.0, 1.0),
                                 std::clamp(roughness_of(i), 0.0, 1.0));
                    return Answer{sum.a, sum.b, 0, 0};
                });
}

}  // namespace
}  // namespace splitsum::tests
