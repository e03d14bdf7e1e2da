#include "splitsum/sphere/orientation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "splitsum/sphere/environment.h"

namespace splitsum {
namespace {

constexpr double pi = std::numbers::pi;

double distance_around(double u, double v) { return std::abs(std::remainder(u - v, 1.0)); }

// The formulas that the conventions' owners publish, written as they write them.
TEST(Orientation, ConventionsLookUpTheColumnTheirFormulaNames) {
    const Vec3d directions[] = {{0.3, 0.2, 0.9}, {-0.8, 0.1, 0.2}, {0.5, -0.4, -0.6}};
    for (const Vec3d& direction : directions) {
        const Vec3d d = normalize(direction);
        const auto u_of = [&](const char* convention) {
            return lat_long_towards(panorama_from_cube({0, false, convention}) * d).u;
        };
        EXPECT_LT(distance_around(u_of("ktx"), 0.5 + std::atan2(d.x, d.z) / (2 * pi)), 1e-14);
        EXPECT_LT(distance_around(u_of("khronos-sampler"), 0.5 + std::atan2(d.z, d.x) / (2 * pi)),
                  1e-14);
        EXPECT_LT(distance_around(u_of("cmgen"), 0.5 + std::atan2(-d.x, d.z) / (2 * pi)), 1e-14);
    }
}

TEST(Orientation, RotationMovesTheMiddleTowardsPlusX) {
    const Vec3d seen = panorama_from_cube({90, false, "ktx"}) * Vec3d(1, 0, 0);
    EXPECT_NEAR(length(seen - Vec3d(0, 0, 1)), 0, 1e-15);
}

TEST(Orientation, MirrorSwapsLeftAndRightBeforeTurning) {
    const Vec3d seen = panorama_from_cube({0, true, "ktx"}) * normalize(Vec3d(1, 0, 1));
    EXPECT_NEAR(length(seen - normalize(Vec3d(-1, 0, 1))), 0, 1e-15);
    // Turned by 90 degrees, what is seen at +X is the middle, mirrored or not.
    EXPECT_NEAR(length(panorama_from_cube({90, true, "ktx"}) * Vec3d(1, 0, 0) - Vec3d(0, 0, 1)), 0,
                1e-15);
}

TEST(Orientation, RefusesWhatDoesNotExist) {
    const Status status = validate({0, false, "blender"});
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().kind, ErrorKind::bad_argument);
    EXPECT_NE(status.error().message.find("khronos-sampler"), std::string::npos);
    EXPECT_FALSE(validate({std::nan(""), false, "ktx"}));
}

}  // namespace
}  // namespace splitsum
