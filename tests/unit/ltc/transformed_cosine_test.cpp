#include "splitsum/ltc/transformed_cosine.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "splitsum/ltc/polygon_light.h"
#include "splitsum/math/quadrature.h"

namespace splitsum {
namespace {

constexpr LtcInverse lopsided = {.m00 = 0.7, .m20 = -0.25, .m02 = 0.6, .m22 = 0.4};

TEST(TransformedCosine, GoesToCosineSpaceAndBack) {
    const Vec3d direction(0.3, -0.8, 0.5);
    const Vec3d back = from_cosine_space(lopsided, to_cosine_space(lopsided, direction));
    EXPECT_NEAR(length(back - direction), 0, 1e-15);
}

TEST(TransformedCosine, OfNoTransformIsTheClampedCosine) {
    EXPECT_NEAR(ltc_density({}, {0.6, 0, 0.8}), 0.8 / std::numbers::pi, 1e-15);
    EXPECT_EQ(ltc_density({}, {0.6, 0, -0.8}), 0);
}

// ∫ density dl over a triangle a + u (b - a) + u v (c - b), dl = u |a·(b x c)| / |x|³ du dv.
double density_over(const LtcInverse& inverse, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const QuadratureRule rule = gauss_legendre(40);
    const double volume = std::abs(dot(a, cross(b, c)));
    return integrate(rule, 0, 1, [&](double u) {
        return integrate(rule, 0, 1, [&](double v) {
            const Vec3d x = a + u * (b - a) + (u * v) * (c - b);
            const double distance = length(x);
            return u * volume * ltc_density(inverse, x / distance) / std::pow(distance, 3);
        });
    });
}

// The theorem that the method stands on (Heitz et al. 2016, eq. 6): straight edges stay straight.
TEST(LtcPolygonLight, IsTheIntegralOfTheDensity) {
    const std::vector<Vec3d> light = {{0.4, 0.3, 1.0}, {-0.7, 0.8, 1.2}, {-1.1, -0.3, 0.9}};
    const double integral = density_over(lopsided, light[0], light[1], light[2]);
    EXPECT_GT(integral, 0.1);
    EXPECT_NEAR(ltc_polygon_light(lopsided, light), integral, 1e-10);
}

TEST(LtcPolygonLight, ClipsWhereTheLobeEnds) {
    // All four corners of a light behind the lobe, and one that surrounds all of it.
    const std::vector<Vec3d> behind = {{9, 1, -4}, {9, -1, -4}, {8, -1, -5}, {8, 1, -5}};
    EXPECT_EQ(ltc_polygon_light(lopsided, behind), 0);
    const double far = 1e6;
    std::vector<Vec3d> around;
    for (const auto& [x, y] : {std::pair(far, far), {-far, far}, {-far, -far}, {far, -far}})
        around.push_back(from_cosine_space(lopsided, {x, y, 1}));
    EXPECT_NEAR(ltc_polygon_light(lopsided, around), 1, 1e-5);
}

}  // namespace
}  // namespace splitsum
