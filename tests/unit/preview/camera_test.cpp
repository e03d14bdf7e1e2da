#include "splitsum/preview/camera.h"

#include <gtest/gtest.h>

#include <vector>

namespace splitsum {
namespace {

void expect_near(const Vec3d& found, const Vec3d& expected) {
    EXPECT_LT(length(found - expected), 1e-12);
}

TEST(Camera, LooksAlongPlusZWithPlusXToTheRight) {
    const Camera camera = camera_for(textbook_scene(), {.width = 101, .height = 51});
    expect_near(camera.cube_from_view * ray_through(camera, 50, 25), Vec3d(0, 0, 1));
    EXPECT_GT((camera.cube_from_view * ray_through(camera, 100, 25)).x, 0);
    EXPECT_GT((camera.cube_from_view * ray_through(camera, 50, 0)).y, 0);
}

TEST(Camera, TurnsFromPlusZTowardsPlusXThenUp) {
    const auto middle = [](double yaw, double pitch) {
        const Camera camera =
            camera_for(textbook_scene(),
                       {.width = 3, .height = 3, .yaw_degrees = yaw, .pitch_degrees = pitch});
        return camera.cube_from_view * ray_through(camera, 1, 1);
    };
    expect_near(middle(90, 0), Vec3d(1, 0, 0));
    expect_near(middle(-90, 0), Vec3d(-1, 0, 0));
    expect_near(middle(33, 90), Vec3d(0, 1, 0));
    const Camera turned = camera_for(
        textbook_scene(), {.width = 3, .height = 3, .yaw_degrees = 40, .pitch_degrees = -25});
    const Mat3d& m = turned.cube_from_view;
    EXPECT_NEAR(determinant(m), 1, 1e-12);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) EXPECT_NEAR(dot(m[i], m[j]), i == j, 1e-12);
    EXPECT_GT(m[1].y, 0);
    EXPECT_NEAR(m[0].y, 0, 1e-12);  // the horizon stays level
}

// Every sphere is whole, at any shape of picture, and the nearest one touches the margin.
TEST(Camera, HasTheWholeSceneInSight) {
    Scene lopsided = textbook_scene();
    lopsided.spheres.push_back({"near and low", Vec3d(-4, -3, -2), 0.8, {}});
    for (const Scene& scene : {textbook_scene(), lopsided})
        for (const auto& [width, height] :
             std::vector<std::pair<int, int>>{{512, 256}, {360, 640}, {333, 333}, {1000, 100}}) {
            const Camera camera = camera_for(scene, {.width = width, .height = height});
            std::vector<int> seen(scene.spheres.size());
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x)
                    if (const auto surface = first_surface(scene, camera, x, y)) {
                        ++seen[size_t(surface->sphere)];
                        EXPECT_TRUE(x > 0 && y > 0 && x < width - 1 && y < height - 1);
                    }
            for (const int pixels : seen) EXPECT_GT(pixels, 8);
        }
}

TEST(Camera, SeesTheFrontOfSpheresWithUnitNormals) {
    const Scene scene = textbook_scene();
    const Camera camera = camera_for(scene, {.width = 256, .height = 128, .yaw_degrees = 70});
    int facing = 0;
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 256; ++x)
            if (const auto surface = first_surface(scene, camera, x, y)) {
                EXPECT_NEAR(length(surface->normal), 1, 1e-12);
                EXPECT_NEAR(length(surface->view), 1, 1e-12);
                EXPECT_GE(dot(surface->normal, surface->view), 0);
                facing += dot(surface->normal, surface->view) > 0.9;
            }
    EXPECT_GT(facing, 14);
}

TEST(Camera, TheNearerSphereHidesTheOther) {
    Scene scene;
    scene.spheres = {{"behind", Vec3d(0, 0, 3), 0.5, {}}, {"before", Vec3d(0, 0, 0), 0.5, {}}};
    const Camera camera = camera_for(scene, {.width = 33, .height = 33});
    ASSERT_TRUE(first_surface(scene, camera, 16, 16));
    EXPECT_EQ(first_surface(scene, camera, 16, 16)->sphere, 1);
}

}  // namespace
}  // namespace splitsum
