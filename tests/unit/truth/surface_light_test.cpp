#include "splitsum/truth/surface_light.h"

#include <gtest/gtest.h>

#include "splitsum/filter/mis_estimate.h"
#include "splitsum/truth/replicated_mean.h"
#include "support/skies.h"
#include "surfaces.h"

namespace splitsum {
namespace {

const Vec3d gold(1, 0.78, 0.34);

Vec3d sampled(const SurfaceLight& light, uint32_t points, uint32_t seed = 0) {
    ReplicatedMean mean;
    mean.extend(light, {seed, 3}, points, PowerShare());
    return light.closed_form() + mean.mean();
}

TEST(SurfaceLight, IsExactUnderUniformLight) {
    const Environment grey =
        tests::environment_of(16, [](const Vec3d&) { return Vec3(0.5f, 1, 2); });
    const LightSampler sampler(grey);
    for (const double metalness : {0.0, 1.0})
        for (const double perceptual_roughness : {0.0, 0.1, 1.0}) {
            const Surface surface =
                tests::lopsided_surface({gold, metalness, perceptual_roughness}, 0.3);
            const SurfaceLight light(sampler, surface);
            EXPECT_EQ(light.densities(), 0);
            const Vec3d expected =
                Vec3d(0.5, 1, 2) * (surface.response.reflectance + surface.response.diffuse_albedo);
            EXPECT_LT(length(light.closed_form() - expected), 1e-15);
        }
}

// A white surface in a white room, through the samplers: one black texel takes away the floor, so
// that nothing but its share is missing.
TEST(SurfaceLight, LosesNothingInAWhiteFurnace) {
    Environment furnace = tests::environment_of(64, [](const Vec3d&) { return Vec3(1); });
    furnace.set_texel(3, 63, Vec3(0));
    const LightSampler sampler(furnace);
    const double black = solid_angle_of_row(63, 64);
    for (const double metalness : {0.0, 1.0})
        for (const double perceptual_roughness : {0.0, 0.2, 0.7, 1.0})
            for (const double n_dot_v : {0.02, 0.5, 1.0}) {
                const Surface surface =
                    tests::lopsided_surface({Vec3d(1), metalness, perceptual_roughness}, n_dot_v);
                const SurfaceLight light(sampler, surface);
                const Vec3d found = sampled(light, 1024);
                EXPECT_NEAR(found.x, 1, 2e-3 + black)
                    << metalness << ' ' << perceptual_roughness << ' ' << n_dot_v;
            }
}

TEST(SurfaceLight, OfAMirrorIsTheTexelThatItShows) {
    const Environment sky = tests::studio_sky(64);
    const LightSampler sampler(sky);
    for (const double n_dot_v : {0.1, 0.6, 1.0}) {
        const Surface surface = tests::lopsided_surface({gold, 1, 0}, n_dot_v);
        const SurfaceLight light(sampler, surface);
        EXPECT_EQ(light.densities(), 0);
        const Vec3d fresnel = gold + std::pow(1 - n_dot_v, 5) * (Vec3d(1) - gold);
        const Vec3d shown(radiance_towards(sky, mirrored_view(surface)));
        EXPECT_LT(length(light.closed_form() - shown * fresnel), 1e-12 * length(shown));
        // What lies below a polished surface still has to be sampled.
        const SurfaceLight coated(sampler, tests::lopsided_surface({gold, 0, 0}, n_dot_v));
        EXPECT_EQ(coated.densities(), 2);
    }
}

// Lobes of 1e-6 to 1e-2 texels that point into a texel's middle.
TEST(SurfaceLight, ApproachesTheMirror) {
    const Environment sky = tests::studio_sky(16);
    const LightSampler sampler(sky);
    const Vec3d normal = direction_of_lat_long(10.4 / 32, 5.3 / 16);
    const Vec3d view = normalize(normal + Vec3d(0.1, 0.05, 0.02));
    for (const double metalness : {0.0, 1.0})
        for (const double perceptual_roughness : {4e-4, 1e-3, 1e-2, 3e-2}) {
            const Material material{gold, metalness, perceptual_roughness};
            const Material polished{gold, metalness, 0};
            const Surface rough =
                surface_of(material, ViewSplitSum(alpha_of(material)), normal, view);
            const Surface smooth = surface_of(polished, ViewSplitSum(0), normal, view);
            const Vec3d found = sampled(SurfaceLight(sampler, rough), 1024);
            const Vec3d expected = sampled(SurfaceLight(sampler, smooth), 1024);
            EXPECT_LT(length(found - expected), 0.01 * length(expected)) << perceptual_roughness;
        }
}

TEST(ReplicatedMean, MayBeExtendedInSteps) {
    const Environment sky = tests::lopsided_sky(32);
    const LightSampler sampler(sky);
    const SurfaceLight light(sampler, tests::lopsided_surface({gold, 0.5, 0.4}, 0.5));
    ReplicatedMean at_once, in_steps;
    at_once.extend(light, {5, 9}, 100, PowerShare());
    for (const uint32_t points : {1u, 16u, 64u, 100u})
        in_steps.extend(light, {5, 9}, points, PowerShare());
    EXPECT_EQ(in_steps.points(), 100u);
    EXPECT_LT(length(at_once.mean() - in_steps.mean()), 1e-13);
    EXPECT_LT(length(at_once.variance_of_mean() - in_steps.variance_of_mean()), 1e-13);
}

TEST(ReplicatedMean, ChangesWithSeedAndSurface) {
    const Environment sky = tests::lopsided_sky(32);
    const LightSampler sampler(sky);
    const SurfaceLight light(sampler, tests::lopsided_surface({gold, 0.5, 0.4}, 0.5));
    const auto mean = [&](const SurfaceKey& key) {
        ReplicatedMean result;
        result.extend(light, key, 16, PowerShare());
        return result.mean();
    };
    EXPECT_EQ(mean({5, 9}), mean({5, 9}));
    EXPECT_NE(mean({5, 9}), mean({9, 5}));
    EXPECT_NE(mean({5, 9}), mean({5, 10}));
}

TEST(ReplicatedMean, KnowsTheVarianceOfSums) {
    const Environment sky = tests::lopsided_sky(32);
    const LightSampler sampler(sky);
    const SurfaceLight light(sampler, tests::lopsided_surface({gold, 0, 0.4}, 0.5));
    ReplicatedMean mean;
    EXPECT_EQ(mean.mean(), Vec3d(0));
    mean.extend(light, {}, 16, PowerShare());
    const Vec3d variance = mean.variance_of_mean();
    EXPECT_NEAR(mean.variance_of_mean({0, 2, 0}), 4 * variance.y, 1e-12 * variance.y);
    // Neighbouring channels err together: more than independent ones would.
    EXPECT_NE(mean.variance_of_mean({1, 1, 1}), variance.x + variance.y + variance.z);
}

}  // namespace
}  // namespace splitsum
