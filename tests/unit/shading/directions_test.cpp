#include "splitsum/shading/directions.h"

#include <gtest/gtest.h>

#include "splitsum/sphere/orientation.h"

namespace splitsum {
namespace {

constexpr double degree = 0.017453292519943295;
const Vec3d direction(0.3, -0.5, 0.8);

TEST(CubeFromWorld, IsItsOwnInverseAndKeepsUp) {
    for (const WorldAxes axes :
         {WorldAxes::left_handed, WorldAxes::right_handed, WorldAxes::three}) {
        const Vec3d cube = cube_from_world(axes, direction);
        EXPECT_EQ(cube_from_world(axes, cube), direction);
        EXPECT_EQ(cube.y, direction.y);
    }
}

// What is ahead of a viewer is the middle of the panorama, cube direction +Z, or opposite to it for
// three.js; what is to the right of a viewer is to the right of the panorama, or opposite as well.
TEST(CubeFromWorld, PutsRightToTheRightOfAhead) {
    const Vec3d up(0, 1, 0);
    EXPECT_EQ(cube_from_world(WorldAxes::left_handed, {0, 0, 1}), Vec3d(0, 0, 1));
    EXPECT_EQ(cube_from_world(WorldAxes::left_handed, {1, 0, 0}), Vec3d(1, 0, 0));
    const Vec3d ahead(0, 0, -1);  // of a right-handed viewer
    EXPECT_EQ(cube_from_world(WorldAxes::right_handed, ahead), Vec3d(0, 0, 1));
    EXPECT_EQ(cube_from_world(WorldAxes::right_handed, cross(ahead, up)), Vec3d(1, 0, 0));
    EXPECT_EQ(cube_from_world(WorldAxes::three, ahead), Vec3d(0, 0, -1));
    EXPECT_EQ(cube_from_world(WorldAxes::three, cross(ahead, up)), Vec3d(-1, 0, 0));
}

TEST(TurnedEnvironment, DoesAtRunTimeWhatRotateDoesAtBakeTime) {
    for (const double degrees : {0.0, 20.0, -135.0, 400.0}) {
        const Mat3d baked = panorama_from_cube({.rotate_degrees = degrees});
        const Vec3d turned = turned_environment(direction, degrees * degree);
        EXPECT_LT(length(turned - baked * direction), 1e-12) << degrees;
    }
}

}  // namespace
}  // namespace splitsum
