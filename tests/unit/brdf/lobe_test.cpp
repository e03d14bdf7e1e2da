#include "splitsum/brdf/lobe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace splitsum {
namespace {

constexpr double pi = std::numbers::pi;

// With s = sin²(theta_h) the integral is 4 a² ∫ (1 - 2 s) / (a² + b s)² ds over [0, 1/2], b = 1 - a²,
// which is elementary: 4 / b (1 - 2 a² / b ln((1 + a²) / (2 a²))).
double closed_form(double alpha) {
    const double a2 = alpha * alpha, b = 1 - a2;
    return 4 / b * (1 - 2 * a2 / b * std::log((1 + a2) / (2 * a2)));
}

TEST(LobeIntegral, OfGgxIsTheClosedForm) {
    for (const double alpha : {1e-8, 1e-6, 1e-4, 0.002, 0.01, 0.1, 0.25, 0.5, 0.9}) {
        const double expected = closed_form(alpha);
        EXPECT_NEAR(lobe_integral({LobeKind::ggx, alpha}), expected, 1e-13 * expected) << alpha;
    }
}

TEST(LobeIntegral, OfTheWidestGgxAndOfTheCosine) {
    // alpha = 1: D is 1 / pi everywhere, and what is left is the cosine's pi.
    EXPECT_NEAR(lobe_integral({LobeKind::ggx, 1}), 1, 1e-14);
    EXPECT_NEAR(lobe_integral({LobeKind::cosine}), pi, 1e-14);
}

TEST(LobeValue, PeaksAtOneOverPiAlphaSquared) {
    for (const double alpha : {1e-8, 0.01, 1.0})
        EXPECT_NEAR(lobe_value({LobeKind::ggx, alpha}, 0) * pi * alpha * alpha, 1, 1e-14);
    EXPECT_EQ(lobe_value({LobeKind::cosine}, 0), 1);
}

TEST(LobeValue, EndsAtTheHorizon) {
    for (const Lobe lobe : {Lobe{LobeKind::ggx, 0.3}, Lobe{LobeKind::cosine}}) {
        EXPECT_EQ(lobe_value(lobe, 1), 0);
        EXPECT_EQ(lobe_value(lobe, 1.5), 0);
        EXPECT_GT(lobe_value(lobe, 0.999), 0);
    }
}

// Half of the peak lies where sin² theta_h = alpha² (sqrt 2 - 1) / b: a versine of 1e-9 at
// perceptual roughness 0.005, where 1 - cos would have kept no digit in single precision.
TEST(LobeValue, KeepsTheWidthOfANarrowLobe) {
    for (const double alpha : {1e-6, 2.5e-5, 0.01}) {
        const double sin2 = alpha * alpha * (std::numbers::sqrt2 - 1) / (1 - alpha * alpha);
        const double half = lobe_value({LobeKind::ggx, alpha}, 2 * sin2);
        const double peak = lobe_value({LobeKind::ggx, alpha}, 0);
        EXPECT_NEAR(half / peak, 0.5 * (1 - 2 * sin2), 1e-12) << alpha;
    }
}

}  // namespace
}  // namespace splitsum
