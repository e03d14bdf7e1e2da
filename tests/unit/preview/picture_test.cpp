#include "splitsum/preview/picture.h"

#include <gtest/gtest.h>

#include <atomic>

#include "splitsum/base/parallel.h"
#include "splitsum/sphere/cubemap_lookup.h"
#include "unit/preview/direction_sky.h"

namespace splitsum {
namespace {

using tests::direction_sky;

BakedLight lopsided_light() {
    BakedLight light;
    light.specular = {direction_sky(32, 0), direction_sky(16, 0.5), direction_sky(8, 1)};
    light.irradiance = direction_sky(8, 2);
    light.split_sum = blank_table(4, 4, 2);
    for (size_t i = 0; i < light.split_sum.values.size(); ++i)
        light.split_sum.values[i] = 0.1f + 0.01f * float(i);
    return light;
}

Vec3 pixel(const Image& picture, int x, int y) {
    const auto row = picture.row(y);
    return {row[size_t(3 * x)], row[size_t(3 * x + 1)], row[size_t(3 * x + 2)]};
}

TEST(Picture, ShowsSpheresBeforeLevel0) {
    const BakedLight light = lopsided_light();
    const Scene scene = textbook_scene();
    const Camera camera =
        camera_for(scene, {.width = 96, .height = 40, .yaw_degrees = 35, .pitch_degrees = 20});
    NoProgress progress;
    const auto picture = baked_picture(scene, camera, light, Background::light, progress);
    ASSERT_TRUE(picture);
    int on_spheres = 0;
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const auto seen = first_surface(scene, camera, x, y);
            on_spheres += seen.has_value();
            const Vec3 meant =
                seen ? Vec3(shade(light, scene.spheres[size_t(seen->sphere)].material, seen->normal,
                                  seen->view))
                     : bilinear_lookup(light.specular[0],
                                       camera.cube_from_view * ray_through(camera, x, y));
            EXPECT_LT(length(pixel(*picture, x, y) - meant), 1e-6);
        }
    EXPECT_GT(on_spheres, 500);
    EXPECT_LT(on_spheres, 96 * 40 - 500);
}

TEST(Picture, IsBlackBehindTheSpheresOnRequest) {
    const Scene scene = textbook_scene();
    const Camera camera = camera_for(scene, {.width = 48, .height = 24});
    NoProgress progress;
    const auto picture =
        baked_picture(scene, camera, lopsided_light(), Background::black, progress);
    ASSERT_TRUE(picture);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x)
            EXPECT_EQ(pixel(*picture, x, y) == Vec3(0), !first_surface(scene, camera, x, y));
}

TEST(Picture, OfTheTruthHasTheSameBackground) {
    const BakedLight light = lopsided_light();
    const Scene scene = textbook_scene();
    const Camera camera = camera_for(scene, {.width = 60, .height = 30, .yaw_degrees = 35});
    TruthPicture truth;
    truth.width = camera.width;
    truth.height = camera.height;
    for (int i = 0; i < truth.width * truth.height; ++i) {
        truth.mean.emplace_back(i, 2 * i, 3 * i);
        truth.standard_error.emplace_back(-i, i, 7 * i);
    }
    NoProgress progress;
    const auto baked = baked_picture(scene, camera, light, Background::light, progress);
    ASSERT_TRUE(baked);
    const Image picture = picture_of(truth, scene, camera, light, Background::light);
    const Image noise = standard_error_of(truth);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const auto i = float(y * camera.width + x);
            const bool on_sphere = first_surface(scene, camera, x, y).has_value();
            EXPECT_EQ(pixel(picture, x, y),
                      on_sphere ? Vec3(i, 2 * i, 3 * i) : pixel(*baked, x, y));
            EXPECT_EQ(pixel(noise, x, y), Vec3(-i, i, 7 * i));
        }
}

TEST(Picture, DoesNotDependOnThreads) {
    const Scene scene = textbook_scene();
    const Camera camera = camera_for(scene, {.width = 128, .height = 64});
    NoProgress progress;
    std::vector<float> first;
    for (const int threads : {1, 7}) {
        const ThreadLimit limit(threads);
        const auto picture =
            baked_picture(scene, camera, lopsided_light(), Background::light, progress);
        ASSERT_TRUE(picture);
        if (first.empty()) first = picture->rgb;
        EXPECT_EQ(picture->rgb, first);
    }
}

/// Counts steps, and wants no more after `limit` of them.
class Impatient final : public Progress {
public:
    explicit Impatient(int limit) : limit_(limit) {}
    void begin(std::string_view, int steps) override { announced = steps; }
    void advance(int steps) override { done += steps; }
    bool cancelled() const override { return done >= limit_; }

    int announced = 0;
    std::atomic<int> done = 0;

private:
    int limit_;
};

TEST(Picture, TellsItsProgressAndStops) {
    const Scene scene = textbook_scene();
    const Camera camera = camera_for(scene, {.width = 64, .height = 32});
    Impatient patient(1000);
    EXPECT_TRUE(baked_picture(scene, camera, lopsided_light(), Background::light, patient));
    EXPECT_EQ(patient.announced, 32);
    EXPECT_EQ(patient.done, 32);
    Impatient impatient(3);
    const auto stopped =
        baked_picture(scene, camera, lopsided_light(), Background::light, impatient);
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().kind, ErrorKind::interrupted);
}

}  // namespace
}  // namespace splitsum
