#include "splitsum/ltc/clipped_sphere.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "splitsum/brdf/polygon.h"

namespace splitsum {
namespace {

// The sphere's outline as a polygon of many corners, clipped.
double by_polygon(double cos_to_centre, double form_factor) {
    constexpr int corners = 4000;
    const double sine = std::sqrt(form_factor), cosine = std::sqrt(1 - form_factor);
    const Basis basis =
        basis_around({std::sqrt(1 - cos_to_centre * cos_to_centre), 0, cos_to_centre});
    std::vector<Vec3d> outline;
    for (int i = 0; i < corners; ++i) {
        const double azimuth = 2 * std::numbers::pi * (i + 0.3) / corners;
        outline.push_back(cosine * basis.normal + sine * (std::cos(azimuth) * basis.tangent +
                                                          std::sin(azimuth) * basis.bitangent));
    }
    return polygon_form_factor(clip_to_horizon(outline)) / form_factor;
}

TEST(ClippedSphere, IsAClippedPolygonOfManyCorners) {
    for (const double cosine : {-0.9, -0.3, -0.01, 0.0, 0.2, 0.6, 0.95})
        for (const double form_factor : {0.01, 0.2, 0.5, 0.9, 0.99})
            EXPECT_NEAR(clipped_sphere_ratio(cosine, form_factor), by_polygon(cosine, form_factor),
                        2e-5)
                << cosine << " " << form_factor;
}

TEST(ClippedSphere, HasItsLimits) {
    for (const double cosine : {-1.0, -0.5, 0.0, 0.3, 1.0}) {
        EXPECT_NEAR(clipped_sphere_ratio(cosine, 0), std::max(cosine, 0.0), 1e-6);
        EXPECT_NEAR(clipped_sphere_ratio(cosine, 1), 0.5 * (1 + cosine), 1e-9);
    }
}

TEST(ClippedSphere, IsWholeAboveTheHorizonAndGoneBelow) {
    EXPECT_EQ(clipped_sphere_ratio(0.6, 0.3), 0.6);
    EXPECT_EQ(clipped_sphere_ratio(-0.6, 0.3), 0);
}

}  // namespace
}  // namespace splitsum
