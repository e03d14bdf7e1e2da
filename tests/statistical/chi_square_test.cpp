#include "support/chi_square.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace splitsum::tests {
namespace {

TEST(UpperIncompleteGamma, HasClosedForms) {
    for (const double x : {1e-8, 0.1, 0.9, 1.5, 3.0, 20.0, 200.0}) {
        const double exponential = std::exp(-x);
        EXPECT_NEAR(upper_incomplete_gamma(1, x) / exponential, 1, 1e-10) << x;
        EXPECT_NEAR(upper_incomplete_gamma(2, x) / ((1 + x) * exponential), 1, 1e-10) << x;
        EXPECT_NEAR(upper_incomplete_gamma(0.5, x) / std::erfc(std::sqrt(x)), 1, 1e-10) << x;
    }
    EXPECT_EQ(upper_incomplete_gamma(3, 0), 1);
}

// Q(a + 1, x) = Q(a, x) + x^a e^-x / Γ(a + 1), on both sides of the border between the methods.
TEST(UpperIncompleteGamma, ObeysItsRecurrence) {
    for (const double a : {0.5, 3.0, 40.5, 400.0, 999.0})
        for (const double ratio : {0.8, 0.98, 1.0, 1.02, 1.2}) {
            const double x = a * ratio;
            const double step = std::exp(a * std::log(x) - x - std::lgamma(a + 1));
            EXPECT_NEAR(upper_incomplete_gamma(a + 1, x), upper_incomplete_gamma(a, x) + step,
                        1e-10)
                << a << ", " << x;
        }
}

TEST(SidakThreshold, HoldsTheFamilyTogether) {
    EXPECT_NEAR(sidak_threshold(1), 0.01, 1e-15);
    EXPECT_NEAR(std::pow(1 - sidak_threshold(7), 7), 0.99, 1e-14);
}

Vec3d uniform_direction(const Vec2d& u) {
    const double z = 1 - 2 * u.x;
    const double sine = std::sqrt(1 - z * z);
    const double phi = 2 * std::numbers::pi * u.y;
    return {sine * std::cos(phi), sine * std::sin(phi), z};
}

constexpr double uniform_pdf = 0.25 * std::numbers::inv_pi;

// Under the truth p-values are themselves uniform: about a tenth of many seeds falls below 0.1.
TEST(ChiSquare, PValuesOfARightSamplerAreUniform) {
    int below = 0;
    for (uint32_t seed = 0; seed < 100; ++seed)
        if (chi_square_fit(
                uniform_direction, [](const Vec3d&) { return uniform_pdf; }, 50'000, seed)
                .p_value < 0.1)
            ++below;
    EXPECT_GE(below, 2);   // fewer: 0.2 % under the truth
    EXPECT_LE(below, 20);  // more: 0.1 % under the truth
}

TEST(ChiSquare, NoticesADensityThatLosesMass) {
    const auto fit = chi_square_fit(
        uniform_direction, [](const Vec3d&) { return 0.95 * uniform_pdf; }, 200'000, 1);
    EXPECT_NEAR(fit.pdf_integral, 0.95, 1e-9);
    EXPECT_LT(fit.p_value, 1e-6);
}

// Samples where the density is 0 must count, although no cell expects them.
TEST(ChiSquare, NoticesSamplesWhereNoneBelong) {
    const auto upper = [](const Vec3d& d) { return d.z > 0 ? 2 * uniform_pdf : 0; };
    const auto leaking = [](const Vec2d& u) {
        const Vec3d d = uniform_direction(u);
        return Vec3d(d.x, d.y, u.x < 0.005 ? -std::abs(d.z) : std::abs(d.z));
    };
    EXPECT_LT(chi_square_fit(leaking, upper, 200'000, 1).p_value, 1e-6);
}

TEST(ChiSquare, NoticesAMirroredAxis) {
    const auto lopsided = [](const Vec3d& d) { return uniform_pdf * (1 + 0.1 * d.y); };
    EXPECT_LT(chi_square_fit(uniform_direction, lopsided, 200'000, 1).p_value, 1e-6);
}

}  // namespace
}  // namespace splitsum::tests
