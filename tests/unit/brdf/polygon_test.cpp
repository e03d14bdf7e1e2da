#include "splitsum/brdf/polygon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace splitsum {
namespace {

using Polygon = std::vector<Vec3d>;

TEST(PolygonFormFactor, OfTheWholeSkyIsOne) {
    const Polygon sky = {{1, 0, 1e-9}, {0, 1, 1e-9}, {-1, -0.2, 1e-9}, {0.3, -1, 1e-9}};
    EXPECT_NEAR(polygon_form_factor(sky), 1, 1e-8);
}

// Corners on a circle of angular radius s about a tilted axis: sin² s cos(tilt).
TEST(PolygonFormFactor, OfManyCornersIsThatOfASphere) {
    const double radius = 0.4;
    for (const double tilt : {0.0, 0.5, 1.1}) {
        const Basis basis = basis_around({std::sin(tilt), 0, std::cos(tilt)});
        Polygon circle;
        for (int i = 0; i < 4000; ++i) {
            const double azimuth = 2 * std::numbers::pi * i / 4000;
            circle.push_back(std::cos(radius) * basis.normal +
                             std::sin(radius) * (std::cos(azimuth) * basis.tangent +
                                                 std::sin(azimuth) * basis.bitangent));
        }
        EXPECT_NEAR(polygon_form_factor(circle), std::pow(std::sin(radius), 2) * std::cos(tilt),
                    1e-6);
    }
}

TEST(PolygonFormFactor, DoesNotMindWindingDistanceOrExtraCorners) {
    const Polygon light = {{0.2, 0.1, 1}, {0.9, 0.2, 0.7}, {0.3, 1.2, 0.4}};
    const double expected = polygon_form_factor(light);
    EXPECT_GT(expected, 0.01);
    EXPECT_NEAR(polygon_form_factor(Polygon{light[2], light[1], light[0]}), expected, 1e-15);
    EXPECT_NEAR(polygon_form_factor(Polygon{7.0 * light[0], light[1], 0.01 * light[2]}), expected,
                1e-15);
    EXPECT_NEAR(polygon_form_factor(
                    Polygon{light[0], 0.5 * (light[0] + light[1]), light[1], light[1], light[2]}),
                expected, 1e-15);
}

TEST(PolygonFormFactor, OfLessThanATriangleIsZero) {
    EXPECT_EQ(polygon_form_factor({}), 0);
    EXPECT_EQ(polygon_form_factor(Polygon{{1, 0, 1}, {0, 1, 1}}), 0);
}

TEST(ClipToHorizon, KeepsWhatIsAboveAndDropsWhatIsBelow) {
    const Polygon above = {{0, 0, 1}, {1, 0, 1}, {0, 1, 2}};
    EXPECT_EQ(clip_to_horizon(above), above);
    EXPECT_TRUE(clip_to_horizon(Polygon{{0, 0, -1}, {1, 0, -1}, {0, 1, -2}}).empty());
}

// A wall 3 wide from 1 below the horizon to 2 above it leans outwards as it rises: 6 of its area are
// above, seen from the side, and the cut is where the wall stands at z = 0.
TEST(ClipToHorizon, CutsWhereTheEdgesCross) {
    const Polygon light = {{1, -1, -1}, {1, 2, -1}, {4, 2, 2}, {4, -1, 2}};
    const Polygon clipped = clip_to_horizon(light);
    ASSERT_EQ(clipped.size(), 4u);
    double area = 0;
    for (size_t i = 0; i < clipped.size(); ++i) {
        const Vec3d &a = clipped[i], &b = clipped[(i + 1) % clipped.size()];
        EXPECT_GE(a.z, 0);
        EXPECT_NEAR(a.x, a.z + 2, 1e-15);
        area += 0.5 * (a.y * b.z - a.z * b.y);
    }
    EXPECT_NEAR(std::abs(area), 6, 1e-14);
}

// One corner above gives a triangle, one below adds a corner.
TEST(ClipToHorizon, CountsItsCorners) {
    EXPECT_EQ(clip_to_horizon(Polygon{{1, 0, 1}, {2, 1, -1}, {2, -1, -1}}).size(), 3u);
    EXPECT_EQ(clip_to_horizon(Polygon{{1, 0, -1}, {2, 1, 1}, {2, -1, 1}}).size(), 4u);
}

}  // namespace
}  // namespace splitsum
