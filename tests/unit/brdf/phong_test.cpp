#include "splitsum/brdf/phong.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "splitsum/math/quadrature.h"

namespace splitsum {
namespace {

constexpr double pi = std::numbers::pi;

Vec3d direction(double theta, double phi) {
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

using Brdf = double (*)(const Vec3d&, const Vec3d&, double);

// ∫ f n·l dl: the share of light from everywhere that leaves towards the view.
double albedo(Brdf brdf, const Vec3d& view, double exponent) {
    const QuadratureRule rule = gauss_legendre(64);
    return integrate(rule, 0, pi / 2, [&](double theta) {
        return integrate(rule, 0, 2 * pi, [&](double phi) {
            return brdf(direction(theta, phi), view, exponent) * std::cos(theta) * std::sin(theta);
        });
    });
}

TEST(Phong, OnlyTheNormalisedLobeIsReciprocal) {
    const Vec3d a = direction(0.3, 0.2), b = direction(0.9, 2.9);
    EXPECT_GT(normalised_phong_brdf(a, b, 20), 0.01);
    EXPECT_DOUBLE_EQ(normalised_phong_brdf(a, b, 20), normalised_phong_brdf(b, a, 20));
    EXPECT_NEAR(phong_brdf(a, b, 20) / phong_brdf(b, a, 20), b.z / a.z, 1e-12);
}

TEST(Phong, OnlyTheNormalisedLobeKeepsEnergy) {
    for (const double exponent : {0.0, 2.0, 20.0}) {
        EXPECT_NEAR(albedo(normalised_phong_brdf, direction(0, 0), exponent), 1, 1e-9);
        double before = 1;
        for (const double theta : {0.4, 0.8, 1.2, 1.5}) {
            const double seen = albedo(normalised_phong_brdf, direction(theta, 0.7), exponent);
            EXPECT_LE(seen, before + 1e-6) << exponent << " " << theta;
            before = seen;
        }
    }
    EXPECT_NEAR(albedo(phong_brdf, direction(0, 0), 2), 2 * pi / 3, 1e-9);
}

TEST(Phong, IsZeroBelowTheHorizon) {
    for (const Brdf brdf : {phong_brdf, normalised_phong_brdf}) {
        EXPECT_EQ(brdf(direction(2, 0), direction(0.5, 0), 3), 0);
        EXPECT_EQ(brdf(direction(0.5, 0), direction(2, 0), 3), 0);
    }
}

}  // namespace
}  // namespace splitsum
