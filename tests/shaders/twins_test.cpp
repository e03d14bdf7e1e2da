// The shader includes and their C++ twins give the same numbers: the includes are compiled as C++.
#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "shaders/glsl_as_cpp.h"
#include "splitsum/base/random.h"
#include "splitsum/math/quadrature.h"
#include "splitsum/plan/roughness_curve.h"
#include "splitsum/table/albedo_lookup.h"
#include "splitsum/table/bilinear.h"
#include "splitsum/table/kinds.h"
#include "splitsum/table/ltc_lookup.h"
#include "splitsum/table/split_sum_lookup.h"

namespace splitsum::tests {
namespace {

constexpr uint32_t input_count = 5000;

// In [-0.1, 1.1), so that clamping is part of the comparison.
float input(uint32_t key) { return 1.2F * unit_float(key) - 0.1F; }

struct CurveTwin {
    RoughnessCurve::Kind kind;
    float (*level)(float, float);
    float (*roughness)(float, float);
};

const CurveTwin curve_twins[] = {
    {RoughnessCurve::Kind::linear, glsl::splitsum_level_linear, glsl::splitsum_roughness_linear},
    {RoughnessCurve::Kind::filament, glsl::splitsum_level_filament,
     glsl::splitsum_roughness_filament},
};

TEST(LevelsGlsl, FindsTheLevelThatTheLibraryFinds) {
    for (const CurveTwin& twin : curve_twins)
        for (const int levels : {1, 2, 7, 14})
            for (uint32_t i = 0; i < input_count; ++i) {
                const float r = input(i);
                const double expected =
                    level_of_roughness({twin.kind, {}}, levels, static_cast<double>(r));
                EXPECT_NEAR(static_cast<double>(twin.level(r, static_cast<float>(levels - 1))),
                            expected, 2e-6)
                    << r;
            }
}

TEST(LevelsGlsl, KnowsTheRoughnessOfEveryLevel) {
    for (const CurveTwin& twin : curve_twins)
        for (const int levels : {1, 2, 7, 14}) {
            const auto expected = roughness_of_levels({twin.kind, {}}, levels);
            for (int level = 0; level < levels; ++level)
                EXPECT_NEAR(static_cast<double>(twin.roughness(static_cast<float>(level),
                                                               static_cast<float>(levels - 1))),
                            expected[static_cast<size_t>(level)], 2e-7);
        }
}

TEST(LevelsGlsl, LevelAndRoughnessAreInverse) {
    for (const CurveTwin& twin : curve_twins)
        for (uint32_t i = 0; i < input_count; ++i) {
            const float r = unit_float(i);
            EXPECT_NEAR(twin.roughness(twin.level(r, 6), 6), r, 1e-3F) << r;
        }
}

TEST(SplitSumGlsl, UsesTheTableAsTheLibraryDoes) {
    for (uint32_t i = 0; i < input_count; ++i) {
        const glsl::vec2 split_sum(0.01F + 0.8F * unit_float(5 * i), 0.2F * unit_float(5 * i + 1));
        const SplitSum sum{static_cast<double>(split_sum.x), static_cast<double>(split_sum.y)};
        const glsl::vec3 f0(unit_float(5 * i + 2), unit_float(5 * i + 3), unit_float(5 * i + 4));
        const glsl::vec3 albedo = glsl::splitsum_directional_albedo(f0, split_sum);
        const glsl::vec3 compensation = glsl::splitsum_energy_compensation(f0, split_sum);
        for (int channel = 0; channel < 3; ++channel) {
            const double reflectance = static_cast<double>(f0[channel]);
            EXPECT_NEAR(static_cast<double>(albedo[channel]), directional_albedo(sum, reflectance),
                        2e-7);
            const double expected = energy_compensation(sum, reflectance);
            EXPECT_NEAR(static_cast<double>(compensation[channel]) / expected, 1, 1e-6);
        }
    }
}

// b and a + b as a table holds them lead to the albedo and the compensation of a and b.
TEST(SplitSumGlsl, UsesAMultiscatterTableAsTheLibraryDoes) {
    for (uint32_t i = 0; i < input_count; ++i) {
        const double bias = 0.2 * static_cast<double>(unit_float(3 * i));
        const double albedo = 0.2 + 0.8 * static_cast<double>(unit_float(3 * i + 1));
        const float f0 = unit_float(3 * i + 2);
        const glsl::vec2 read(bias, albedo);
        const SplitSum sum = split_sum_of_multiscatter(bias, albedo);
        EXPECT_NEAR(static_cast<double>(
                        glsl::splitsum_directional_albedo_of_multiscatter(glsl::vec3(f0), read).y),
                    directional_albedo(sum, static_cast<double>(f0)), 2e-7);
        EXPECT_NEAR(
            static_cast<double>(
                glsl::splitsum_energy_compensation_of_multiscatter(glsl::vec3(f0), read).z) /
                energy_compensation(sum, static_cast<double>(f0)),
            1, 1e-6);
    }
}

TEST(SplitSumGlsl, ScattersBetweenFacetsAsTheLibraryDoes) {
    for (uint32_t i = 0; i < input_count; ++i) {
        const float view = unit_float(3 * i), light = unit_float(3 * i + 1);
        const float average = i % 7 == 0 ? 1.0F : unit_float(3 * i + 2);
        const double expected = multiple_scattering(
            static_cast<double>(view), static_cast<double>(light), static_cast<double>(average));
        EXPECT_NEAR(static_cast<double>(glsl::splitsum_multiple_scattering(view, light, average)) /
                        std::max(expected, 1e-3),
                    expected / std::max(expected, 1e-3), 1e-5);
        const double of_lost =
            multiple_scattering_of_lost(static_cast<double>(view), static_cast<double>(light),
                                        0.5 * static_cast<double>(average));
        EXPECT_NEAR(static_cast<double>(
                        glsl::splitsum_multiple_scattering_of_lost(view, light, 0.5F * average)),
                    of_lost, 1e-6 * of_lost);
    }
}

TEST(ClothGlsl, UsesTheTableAsTheLibraryDoes) {
    for (uint32_t i = 0; i < input_count; ++i) {
        const glsl::vec3 color(unit_float(4 * i), unit_float(4 * i + 1), unit_float(4 * i + 2));
        const Vec3d same(color.x, color.y, color.z);
        const float albedo = 4 * unit_float(4 * i + 3);  // cloth seen edge on returns more than 1
        const glsl::vec3 reflected = glsl::splitsum_cloth_reflectance(color, albedo);
        const Vec3d expected = cloth_reflectance(same, static_cast<double>(albedo));
        for (int channel = 0; channel < 3; ++channel)
            EXPECT_NEAR(static_cast<double>(reflected[channel]), expected[channel], 1e-6);
        EXPECT_NEAR(static_cast<double>(glsl::splitsum_below_cloth(color, albedo)),
                    below_cloth(same, static_cast<double>(albedo)), 1e-6);
    }
}

TEST(AreaLightGlsl, ReadsTablesWhereTheLibraryDoes) {
    const TableKind kind = *kind_of({.kind = "ltc-ggx"});
    const TablePlan plan = default_plan(kind);
    for (const int size : {2, 17, 64})
        for (uint32_t i = 0; i < 500; ++i) {
            const float n_dot_v = input(2 * i), r = input(2 * i + 1);
            const glsl::vec2 found =
                glsl::splitsum_ltc_coordinates(n_dot_v, r, static_cast<float>(size));
            const Vec2d expected = texture_coordinates(
                plan, size, kind.view_axis, static_cast<double>(n_dot_v), static_cast<double>(r));
            EXPECT_NEAR(static_cast<double>(found.x), expected.x, 3e-7);
            EXPECT_NEAR(static_cast<double>(found.y), expected.y, 3e-7);
            const glsl::vec2 sphere =
                glsl::splitsum_ltc_sphere_coordinates(2 * n_dot_v - 1, r, static_cast<float>(size));
            const Vec2d there = ltc_sphere_coordinates(2 * static_cast<double>(n_dot_v) - 1,
                                                       static_cast<double>(r), size);
            EXPECT_NEAR(static_cast<double>(sphere.x), there.x, 3e-7);
            EXPECT_NEAR(static_cast<double>(sphere.y), there.y, 3e-7);
        }
}

TEST(AreaLightGlsl, CarriesDirectionsAndReflectsAsTheLibraryDoes) {
    for (uint32_t i = 0; i < input_count; ++i) {
        std::array<float, 11> numbers{};
        for (uint32_t k = 0; k < numbers.size(); ++k)
            numbers[k] = 2 * unit_float(static_cast<uint32_t>(numbers.size()) * i + k) - 1;
        const std::array<double, 6> read = {numbers[0], numbers[1], numbers[2],
                                            numbers[3], numbers[4], numbers[5]};
        const glsl::vec4 layer0(numbers[0], numbers[1], numbers[2], numbers[3]);
        const glsl::vec4 layer1(numbers[4], numbers[5], 0, 0);
        const glsl::vec3 direction(numbers[6], numbers[7], numbers[8]);
        const glsl::vec3 carried = glsl::splitsum_ltc_inverse(layer0) * direction;
        const Vec3d expected =
            to_cosine_space(ltc_inverse(read), {direction.x, direction.y, direction.z});
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_NEAR(static_cast<double>(carried[axis]), expected[axis], 1e-6);
        const glsl::vec3 f0(numbers[9]);
        EXPECT_NEAR(static_cast<double>(glsl::splitsum_ltc_reflectance(f0, layer1).y),
                    ltc_reflectance(read, static_cast<double>(numbers[9])), 1e-6);
    }
}

// A table whose texels are the coordinates of their own centres reads back the coordinates, so the
// shader's coordinates and the library's agree on where the centres are.
TEST(SplitSumGlsl, PutsTexelCentresWhereTheLibraryDoes) {
    constexpr int size = 64;
    Table table = blank_table(size, size, 2);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            table.texel(x, y)[0] = (static_cast<float>(x) + 0.5F) / size;
            table.texel(x, y)[1] = (static_cast<float>(y) + 0.5F) / size;
        }
    const double first = 0.5 / size;
    for (uint32_t i = 0; i < input_count; ++i) {
        const float n_dot_v = input(2 * i);
        const float perceptual_roughness = input(2 * i + 1);
        const glsl::vec2 at = glsl::splitsum_table_coordinates(n_dot_v, perceptual_roughness);
        const SplitSum read =
            look_up(table, static_cast<double>(n_dot_v), static_cast<double>(perceptual_roughness));
        EXPECT_NEAR(read.a, std::clamp(static_cast<double>(at.x), first, 1 - first), 1e-6);
        EXPECT_NEAR(read.b, std::clamp(static_cast<double>(at.y), first, 1 - first), 1e-6);
    }
}

TEST(SplitSumGlsl, FindsTexelsAtTheEdgesWhereTheLibraryDoes) {
    TablePlan plan;
    plan.layout = TexelLayout::edge;
    for (const int size : {2, 17, 64})
        for (uint32_t i = 0; i < 500; ++i) {
            const float n_dot_v = input(2 * i), r = input(2 * i + 1);
            const glsl::vec2 found = glsl::splitsum_edge_coordinates(
                glsl::splitsum_table_coordinates(n_dot_v, r), static_cast<float>(size));
            const Vec2d expected = texture_coordinates(
                plan, size, ViewAxis::cosine, static_cast<double>(n_dot_v), static_cast<double>(r));
            EXPECT_NEAR(static_cast<double>(found.x), expected.x, 2e-7);
            EXPECT_NEAR(static_cast<double>(found.y), expected.y, 2e-7);
        }
}

// Over all directions of light the added lobe returns what one bounce lost, and light and view may
// change places.
TEST(SplitSumGlsl, MultipleScatteringReturnsWhatWasLost) {
    const auto energy = [](double mu) { return 0.9 - 0.4 * mu; };  // of any surface
    const QuadratureRule rule = gauss_legendre(16);
    const double average = integrate(rule, 0, 1, [&](double mu) { return 2 * mu * energy(mu); });
    const auto lobe = [&](double view, double light) {
        return static_cast<double>(glsl::splitsum_multiple_scattering(
            static_cast<float>(energy(view)), static_cast<float>(energy(light)),
            static_cast<float>(average)));
    };
    for (const double view : {0.0, 0.3, 1.0}) {
        const double returned = 2 * std::numbers::pi * integrate(rule, 0, 1, [&](double mu) {
                                    return mu * lobe(view, mu);
                                });
        EXPECT_NEAR(returned, 1 - energy(view), 1e-6);
        EXPECT_NEAR(lobe(view, 0.7), lobe(0.7, view), 1e-7);
    }
}

}  // namespace
}  // namespace splitsum::tests
