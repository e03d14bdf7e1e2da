#include "splitsum/filter/lobe_over_patch.h"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

namespace splitsum {
namespace {

constexpr double pi = std::numbers::pi;

std::vector<Lobe> some_lobes() {
    std::vector<Lobe> lobes = {{LobeKind::cosine}};
    for (const double alpha : {1e-6, 1e-3, 0.01, 0.3, 1.0}) lobes.push_back({LobeKind::ggx, alpha});
    return lobes;
}

// The sum over a lat-long grid of `rows` whose columns start at the lobe's azimuth + `turn`.
double sum_over_sphere(const Lobe& lobe, double lobe_theta, int rows, double turn) {
    const int columns = 2 * rows;
    double sum = 0;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            const double azimuth0 = -pi + 2 * pi * x / columns + turn;
            sum += lobe_over_patch(
                lobe, lobe_theta,
                {pi * y / rows, pi * (y + 1) / rows, azimuth0, azimuth0 + 2 * pi / columns});
        }
    return sum;
}

TEST(LobeOverPatch, AddsUpToTheLobesIntegral) {
    for (const Lobe& lobe : some_lobes())
        for (const double theta : {0.0, 1e-9, 0.02, 0.7, 0.5 * pi, 2.9, pi})
            for (const int rows : {1, 3, 16}) {
                const double expected = lobe_integral(lobe);
                // Measured: 2.6e-7 for theta 0.02, where the horizon runs along the rows; 7e-8
                // for the others.
                const double limit = (theta == 0.02 ? 4e-7 : 1e-7) * expected;
                EXPECT_NEAR(sum_over_sphere(lobe, theta, rows, 0), expected, limit)
                    << "alpha " << lobe.alpha << " theta " << theta << " rows " << rows;
            }
}

TEST(LobeOverPatch, DoesNotMindWhereTheGridStarts) {
    const Lobe lobe{LobeKind::ggx, 0.05};
    const double expected = lobe_integral(lobe);
    for (const double turn : {0.01, 0.1, 0.19})  // less than the half column that is harmless
        EXPECT_NEAR(sum_over_sphere(lobe, 1.1, 8, turn), expected, 1e-7 * expected);
}

TEST(LobeOverPatch, IsAdditive) {
    for (const Lobe& lobe : some_lobes()) {
        const double whole = lobe_over_patch(lobe, 1.0, {0.7, 1.3, -0.2, 0.9});
        const double parts = lobe_over_patch(lobe, 1.0, {0.7, 1.01, -0.2, 0.9}) +
                             lobe_over_patch(lobe, 1.0, {1.01, 1.3, -0.2, 0.3}) +
                             lobe_over_patch(lobe, 1.0, {1.01, 1.3, 0.3, 0.9});
        EXPECT_NEAR(whole, parts, 2e-9 * whole) << lobe.alpha;
    }
}

TEST(LobeOverPatch, IsSymmetricInTheAzimuthAndNothingBelowTheHorizon) {
    const Lobe lobe{LobeKind::ggx, 0.2};
    EXPECT_NEAR(lobe_over_patch(lobe, 0.4, {0.5, 0.8, 0.1, 0.6}) /
                    lobe_over_patch(lobe, 0.4, {0.5, 0.8, -0.6, -0.1}),
                1, 1e-12);
    EXPECT_EQ(lobe_over_patch(lobe, 0.1, {1.8, 2.2, -0.5, 0.5}), 0);
}

}  // namespace
}  // namespace splitsum
