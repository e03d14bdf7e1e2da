#include "splitsum/brdf/ggx.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace splitsum {
namespace {

constexpr double alphas[] = {1e-8, 1e-6, 1e-3, 0.1, 0.5, 1.0};

// The share of normals within an angle is xi = tan² / (alpha² + tan²): the sampler is its inverse,
// to the last digits however narrow the lobe. 1 - cos² would fail here from alpha = 1e-3 down.
TEST(GgxSampling, InvertsTheDistributionFunction) {
    for (const double alpha : alphas)
        for (const double xi : {1e-6, 0.1, 0.5, 0.99, 1 - 1e-9}) {
            const GgxNormal sample = sample_ggx_normal({xi, 0.2}, alpha);
            const double sin2 = sample.sin2_theta;
            const double cos2 = sample.normal.z * sample.normal.z;
            EXPECT_NEAR(sin2 / (alpha * alpha * cos2 + sin2) / xi, 1, 1e-12) << alpha << ", " << xi;
        }
}

TEST(GgxSampling, SineBelongsToTheUnitNormal) {
    for (const double alpha : alphas)
        for (const double xi : {0.0, 0.3, 0.7, 0.999}) {
            const GgxNormal sample = sample_ggx_normal({xi, 0.7}, alpha);
            const Vec3d& h = sample.normal;
            EXPECT_NEAR(length(h), 1, 1e-15);
            EXPECT_NEAR(sample.sin2_theta, h.x * h.x + h.y * h.y, 1e-14 * sample.sin2_theta);
        }
}

TEST(GgxSampling, OfTheMirrorIsTheNormal) {
    const GgxNormal sample = sample_ggx_normal({0.4, 0.3}, 0);
    EXPECT_EQ(sample.normal, Vec3d(0, 0, 1));
    EXPECT_EQ(sample.sin2_theta, 0);
}

TEST(GgxSampling, AzimuthTurnsFromXTowardsY) {
    const Vec3d quarter = sample_ggx_normal({0.5, 0.25}, 1).normal;
    EXPECT_NEAR(quarter.x, 0, 1e-15);
    EXPECT_GT(quarter.y, 0.5);
}

// D cos theta dw over the cap within theta is the distribution function above, so its derivative
// by sin² is pi D.
TEST(GgxDensity, IsTheDerivativeOfTheDistributionFunction) {
    for (const double alpha : alphas)
        for (const double multiple : {0.1, 1.0, 5.0}) {
            const double sin2 = std::min(0.9, multiple * alpha * alpha);
            const double step = 1e-4 * sin2;
            const auto share = [=](double s) { return s / (alpha * alpha * (1 - s) + s); };
            const double slope = (share(sin2 + step) - share(sin2 - step)) / (2 * step);
            EXPECT_NEAR(ggx_density(sin2, alpha) * std::numbers::pi / slope, 1, 1e-6) << alpha;
        }
}

TEST(GgxDensity, AtThePeakIsOneOverPiAlphaSquared) {
    for (const double alpha : alphas)
        EXPECT_NEAR(ggx_density(0, alpha) * std::numbers::pi * alpha * alpha, 1, 1e-14);
}

TEST(GgxNormalPdf, IsZeroBelowTheSurface) {
    EXPECT_EQ(ggx_normal_pdf({0.6, 0, -0.8}, 0.5), 0);
    EXPECT_GT(ggx_normal_pdf({0.6, 0, 0.8}, 0.5), 0);
}

}  // namespace
}  // namespace splitsum
