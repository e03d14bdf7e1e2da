#include "splitsum/sphere/ring_pyramid.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/lopsided_sky.h"

namespace splitsum {
namespace {

TEST(RingPyramid, EveryLevelKeepsTheMean) {
    for (const int height : {1, 2, 3, 17, 64}) {
        const Environment sky = tests::lopsided_sky(height);
        const Vec3d mean = mean_radiance(sky);
        for (const RingLevel& level : ring_pyramid(sky).levels)
            EXPECT_LT(length(mean_radiance(level) - mean), 1e-6 * length(mean))
                << height << " rows, level of " << level.ring_count;
    }
}

TEST(RingPyramid, LevelsAreHalfAnOctaveApart) {
    const auto levels = ring_pyramid(tests::lopsided_sky(64)).levels;
    ASSERT_EQ(levels[0].ring_count, 64);
    for (size_t i = 1; i + 4 < levels.size(); ++i)
        EXPECT_NEAR(levels[i].solid_angle() / levels[i - 1].solid_angle(), 2, 0.15);
}

// A linear function is what bilinear interpolation reproduces: no jump at the seam or the poles.
// The rings at the poles have four texels, between which a cosine is off by up to 1e-2.
TEST(RingPyramid, LookupsAreSmoothAcrossSeamAndPoles) {
    const Environment slope =
        tests::environment_of(64, [](const Vec3d& d) { return Vec3(2 + d.x, 2 + d.y, 2 + d.z); });
    const RingPyramid pyramid = ring_pyramid(slope);
    const RingLevel& level = pyramid.levels[2];
    for (int i = 0; i < 500; ++i) {
        const double along = i / 500.0;
        const Vec3d seam = direction_of_lat_long(
            along < 0.5 ? 0.001 * along : 1 - 0.001 * (1 - along), 0.1 + 0.8 * along);
        const Vec3d pole = normalize(Vec3d(0.2 * (along - 0.5), i % 2 ? 1 : -1, 0.003));
        for (const Vec3d& d : {seam, pole}) {
            const Vec3 seen = radiance_towards(level, d);
            ASSERT_NEAR(seen.x, 2 + d.x, 1.2e-2) << d.x << " " << d.y << " " << d.z;
            ASSERT_NEAR(seen.y, 2 + d.y, 1.2e-2) << d.x << " " << d.y << " " << d.z;
            ASSERT_NEAR(seen.z, 2 + d.z, 1.2e-2) << d.x << " " << d.y << " " << d.z;
        }
    }
}

}  // namespace
}  // namespace splitsum
