#include "splitsum/preview/split_exact.h"

#include <gtest/gtest.h>

#include <cmath>

#include "splitsum/base/parallel.h"
#include "splitsum/preview/sphere_surfaces.h"
#include "splitsum/sphere/orientation.h"
#include "support/skies.h"

namespace splitsum {
namespace {

const Mat3d turned_and_mirrored = panorama_from_cube({.rotate_degrees = 40, .mirror = true});

Scene scene_of(const std::vector<Material>& materials) {
    Scene scene;
    for (size_t i = 0; i < materials.size(); ++i)
        scene.spheres.push_back({"", Vec3d(double(i), 0, 0), 0.45, materials[i]});
    return scene;
}

const std::vector<Material> some = {{Vec3d(1, 0.8, 0.3), 1, 0},
                                    {Vec3d(1, 0.8, 0.3), 0, 0},
                                    {Vec3d(1, 0.8, 0.3), 1, 0.1},
                                    {Vec3d(1, 0.8, 0.3), 0.5, 0.6},
                                    {Vec3d(1, 0.8, 0.3), 0, 1}};

Camera camera_of(const Scene& scene) {
    return camera_for(scene, {.width = 96, .height = 32, .yaw_degrees = 70, .pitch_degrees = 10});
}

SplitExact drawn(const Environment& sky, const Scene& scene, int checks) {
    NoProgress progress;
    auto result = split_exact(scene, camera_of(scene), sky, turned_and_mirrored, checks, progress);
    EXPECT_TRUE(result);
    return std::move(*result);
}

TEST(SplitExact, IsTheReferenceAtThePixelsThatAreChecked) {
    const Scene scene = scene_of(some);
    for (const tests::NamedSky& sky : tests::skies()) {
        const SplitExact exact = drawn(sky.make(128), scene, 12);
        EXPECT_EQ(exact.checked.texels, 12 * 5);
        EXPECT_LT(exact.checked.rel_rms, 1e-5) << sky.name;
        EXPECT_LT(exact.checked.max_rel, 1e-3) << sky.name;
    }
}

TEST(SplitExact, ReflectsUniformLightAsTheSurfaceDoes) {
    const Environment grey = tests::environment_of(32, [](const Vec3d&) { return Vec3(2); });
    const Scene scene = scene_of(some);
    const Camera camera = camera_of(scene);
    const SphereSurfaces surfaces(scene, turned_and_mirrored);
    const SplitExact exact = drawn(grey, scene, 1);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            Vec3d expected(0);
            if (const auto seen = first_surface(scene, camera, x, y)) {
                const SurfaceResponse response = surfaces.at(*seen).response;
                expected = 2.0 * (response.reflectance + response.diffuse_albedo);
            }
            const auto row = exact.radiance.row(y);
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(double(row[size_t(3 * x + c)]), expected[c], 2e-5);
        }
}

// The mirror image of a pixel's own direction, turned into the panorama.
TEST(SplitExact, ShowsThePanoramasTexelsInAMirror) {
    const Environment sky = tests::lopsided_sky(32);
    const Scene scene = scene_of({{Vec3d(1), 1, 0}});
    const Camera camera = camera_of(scene);
    const SplitExact exact = drawn(sky, scene, 4);
    EXPECT_LT(exact.checked.max_rel, 1e-6);
    int seen_pixels = 0;
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const auto seen = first_surface(scene, camera, x, y);
            if (!seen) continue;
            ++seen_pixels;
            const Vec3d mirrored = 2 * dot(seen->normal, seen->view) * seen->normal - seen->view;
            const Vec3 texel = radiance_towards(sky, turned_and_mirrored * mirrored);
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(exact.radiance.row(y)[size_t(3 * x + c)], texel[c], 1e-5f * texel[c]);
        }
    EXPECT_GT(seen_pixels, 300);
}

TEST(SplitExact, DoesNotDependOnThreads) {
    const Environment sky = tests::studio_sky(64);
    const Scene scene = scene_of(some);
    const auto with = [&](int threads) {
        const ThreadLimit limit(threads);
        return drawn(sky, scene, 3);
    };
    const SplitExact one = with(1), many = with(7);
    EXPECT_EQ(one.radiance.rgb, many.radiance.rgb);
    EXPECT_EQ(one.checked.rel_rms, many.checked.rel_rms);
}

class Cancelled final : public Progress {
public:
    void begin(std::string_view, int) override {}
    void advance(int) override {}
    bool cancelled() const override { return true; }
};

TEST(SplitExact, EndsWhenCancelled) {
    Cancelled progress;
    const Scene scene = scene_of(some);
    const auto result = split_exact(scene, camera_of(scene), tests::studio_sky(16),
                                    turned_and_mirrored, 1, progress);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().kind, ErrorKind::interrupted);
}

}  // namespace
}  // namespace splitsum
