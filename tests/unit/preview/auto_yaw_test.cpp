#include "splitsum/preview/auto_yaw.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "splitsum/preview/camera.h"

namespace splitsum {
namespace {

constexpr double degree = std::numbers::pi / 180;

Vec3d sun_at(double azimuth_degrees, double height_degrees) {
    const double a = azimuth_degrees * degree, h = height_degrees * degree;
    return {std::cos(h) * std::sin(a), std::sin(h), std::cos(h) * std::cos(a)};
}

// Irradiance of an even sky and a sun.
Cubemap lit_from(const Vec3d& sun, float strength = 5) {
    Cubemap light(8);
    for (int face = 0; face < face_count; ++face)
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x)
                light.at(face, x, y) =
                    Vec3(1.0f + strength * float(std::max(
                                               0.0, dot(sun, direction_of_texel(face, x, y, 8)))));
    return light;
}

TEST(AutoYaw, HasTheSunOnTheLeftAndALittleBehind) {
    for (const double azimuth : {-170.0, -95.0, 0.0, 3.0, 44.0, 130.0, 179.0})
        for (const double height : {-20.0, 0.0, 60.0}) {
            const Vec3d sun = sun_at(azimuth, height);
            const double yaw = auto_yaw_degrees(lit_from(sun));
            const Camera camera =
                camera_for(textbook_scene(), {.width = 64, .height = 32, .yaw_degrees = yaw});
            const Vec3d seen = transpose(camera.cube_from_view) * sun / std::cos(height * degree);
            EXPECT_LT(seen.x, -0.85) << azimuth;
            EXPECT_LT(seen.z, -0.2) << azimuth;
            EXPECT_GT(seen.z, -0.5) << azimuth;
            EXPECT_EQ(std::remainder(yaw, 5), 0);
            EXPECT_LE(std::abs(yaw), 180);
        }
}

TEST(AutoYaw, OfLightFromAllAroundOrAboveIsNone) {
    EXPECT_EQ(auto_yaw_degrees(lit_from(Vec3d(1, 0, 0), 0)), 0);
    EXPECT_EQ(auto_yaw_degrees(lit_from(Vec3d(0, 1, 0))), 0);
    EXPECT_EQ(auto_yaw_degrees(Cubemap(4)), 0);
}

}  // namespace
}  // namespace splitsum
