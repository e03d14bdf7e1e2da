#include "splitsum/table/split_sum_lookup.h"

#include <gtest/gtest.h>

#include <numbers>

#include "splitsum/math/quadrature.h"

namespace splitsum {
namespace {

// 3 columns, 2 rows, nothing symmetric.
Table lopsided_table() { return {3, 2, 2, 1, {1, 10, 2, 20, 4, 40, 8, 80, 16, 160, 32, 320}}; }

TEST(LookUp, ReturnsTexelsAtTheirCentres) {
    const Table table = lopsided_table();
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x) {
            const SplitSum sum = look_up(table, (x + 0.5) / 3, (y + 0.5) / 2);
            EXPECT_NEAR(sum.a, static_cast<double>(table.texel(x, y)[0]), 1e-12);
            EXPECT_NEAR(sum.b, static_cast<double>(table.texel(x, y)[1]), 1e-12);
        }
}

TEST(LookUp, IsLinearBetweenTexels) {
    const SplitSum sum = look_up(lopsided_table(), (0.5 + 0.25) / 3, (0.5 + 0.5) / 2);
    EXPECT_NEAR(sum.a, 0.5 * (0.75 * 1 + 0.25 * 2) + 0.5 * (0.75 * 8 + 0.25 * 16), 1e-12);
}

TEST(LookUp, ClampsAtTheEdges) {
    const Table table = lopsided_table();
    EXPECT_EQ(look_up(table, 0, 0).a, 1);
    EXPECT_EQ(look_up(table, -3, -1).a, 1);
    EXPECT_EQ(look_up(table, 1, 1).b, 320);
    EXPECT_EQ(look_up(table, 7, 0).a, 4);
}

TEST(LookUp, WorksOnASingleTexel) {
    const Table table{1, 1, 2, 1, {0.25F, 0.75F}};
    EXPECT_EQ(look_up(table, 0.9, 0.1).a, 0.25);
}

TEST(DirectionalAlbedo, IsLinearInTheReflectance) {
    EXPECT_DOUBLE_EQ(directional_albedo({0.8, 0.1}, 0.04), 0.04 * 0.8 + 0.1);
    EXPECT_DOUBLE_EQ(directional_albedo({0.8, 0.1}, 1), 0.9);
}

TEST(EnergyCompensation, GivesAWhiteFurnaceBack) {
    const SplitSum sum{0.55, 0.08};
    EXPECT_NEAR(directional_albedo(sum, 1) * energy_compensation(sum, 1), 1, 1e-15);
    EXPECT_EQ(energy_compensation(sum, 0), 1);
    EXPECT_NEAR(reflectance(sum, 1), 1, 1e-15);
}

TEST(SplitSumOfMultiscatter, IsWhatTheTableWasMadeOf) {
    const SplitSum sum = split_sum_of_multiscatter(0.08, 0.63);
    EXPECT_DOUBLE_EQ(sum.a, 0.55);
    EXPECT_DOUBLE_EQ(sum.b, 0.08);
}

// Over all directions of light the added lobe returns what one bounce lost, and light and view may
// change places.
TEST(MultipleScattering, ReturnsWhatWasLost) {
    const auto energy = [](double mu) { return 0.9 - 0.4 * mu; };  // of any surface
    const QuadratureRule rule = gauss_legendre(16);
    const double average = integrate(rule, 0, 1, [&](double mu) { return 2 * mu * energy(mu); });
    const auto lobe = [&](double view, double light) {
        return multiple_scattering(energy(view), energy(light), average);
    };
    for (const double view : {0.0, 0.3, 1.0}) {
        const double returned = 2 * std::numbers::pi * integrate(rule, 0, 1, [&](double mu) {
                                    return mu * lobe(view, mu);
                                });
        EXPECT_NEAR(returned, 1 - energy(view), 1e-12);
        EXPECT_NEAR(lobe(view, 0.7), lobe(0.7, view), 1e-15);
        EXPECT_NEAR(multiple_scattering_of_lost(1 - energy(view), 1 - energy(0.7), 1 - average),
                    lobe(view, 0.7), 1e-12);
    }
}

}  // namespace
}  // namespace splitsum
