// The SIMD sums against the scalar lookups that are their specification, for every remainder of the
// number of samples.
#include "splitsum/filter/sample_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/lopsided_sky.h"

namespace splitsum {
namespace {

std::vector<Vec3d> some_directions() {
    std::vector<Vec3d> directions = {{0, 1, 0}, {0, -1, 0}, {0, 0, -1}, {1, 0, 0}, {0, 0, 1}};
    for (int i = 0; i < 12; ++i)
        directions.push_back(
            direction_of_lat_long(std::fmod(0.137 + 0.618034 * i, 1.0), (i + 0.5) / 12));
    return directions;
}

Vec3d sample_direction(const SampleSet& set, const Frame& frame, size_t i) {
    return double(set.x[i]) * Vec3d(frame.tangent) + double(set.y[i]) * Vec3d(frame.bitangent) +
           double(set.z[i]) * Vec3d(frame.normal);
}

// Calls expect(samples, frame) for sets of 1 to 40 samples and frames all over the sphere.
template <class Expect>
void for_every_remainder(const Expect& expect) {
    for (int count = 1; count <= 40; ++count) {
        const SampleSet samples = importance_samples({LobeKind::ggx, 0.3}, count);
        for (const Vec3d& d : some_directions()) {
            SCOPED_TRACE(count);
            expect(samples, frame_towards(d, 0.1 * count));
        }
    }
}

// The texels around a direction: a sample on an edge between texels may fall to either side.
struct Bounds {
    Vec3d low, high;
};

Bounds bounds_around(const Environment& sky, const Vec3d& direction) {
    Bounds bounds{Vec3d(1e30), Vec3d(-1e30)};
    const LatLong at = lat_long_towards(direction);
    for (const double du : {-1e-6, 0.0, 1e-6})
        for (const double dv : {-1e-6, 0.0, 1e-6}) {
            const double v = std::clamp(at.v + dv, 0.0, 1.0);
            const Vec3d seen(radiance_towards(sky, direction_of_lat_long(at.u + du, v)));
            bounds.low = glm::min(bounds.low, seen);
            bounds.high = glm::max(bounds.high, seen);
        }
    return bounds;
}

TEST(SumOfTexels, IsTheWeightedSumOfScalarLookups) {
    for (const int height : {1, 5, 64}) {
        const Environment sky = tests::lopsided_sky(height);
        for_every_remainder([&](const SampleSet& samples, const Frame& frame) {
            Vec3d low(0), high(0);
            for (size_t i = 0; i < samples.count; ++i) {
                const Bounds one = bounds_around(sky, sample_direction(samples, frame, i));
                low += double(samples.weight[i]) * one.low;
                high += double(samples.weight[i]) * one.high;
            }
            const Vec3d sum(sum_of_texels(sky, samples, frame));
            for (int c = 0; c < 3; ++c) {
                ASSERT_GE(sum[c], low[c] * (1 - 1e-6)) << height;
                ASSERT_LE(sum[c], high[c] * (1 + 1e-6)) << height;
            }
        });
    }
}

TEST(SumOfRings, IsTheWeightedSumOfScalarLookups) {
    for (const int height : {1, 5, 64}) {
        const RingPyramid pyramid = ring_pyramid(tests::lopsided_sky(height));
        for_every_remainder([&](const SampleSet& samples, const Frame& frame) {
            RingLookups lookups;
            Vec3d expected(0);
            for (size_t i = 0; i < samples.x.size(); ++i) {  // a level of its own for each sample
                const RingLevel& level = pyramid.levels[i * 7 % pyramid.levels.size()];
                lookups.level.push_back(&level);
                lookups.ring_count.push_back(float(level.ring_count));
                if (i < samples.count)
                    expected += double(samples.weight[i]) *
                                Vec3d(radiance_towards(level, sample_direction(samples, frame, i)));
            }
            const Vec3d sum(sum_of_rings(lookups, samples, frame));
            // 1e-7 turns of azimuth on 64 rows beside a sun 20 times brighter than its neighbour.
            for (int c = 0; c < 3; ++c) ASSERT_NEAR(sum[c], expected[c], 3e-4 * expected[c]);
        });
    }
}

TEST(FrameTowards, IsOrthonormalAndTurnsAboutItsNormal) {
    for (const Vec3d& d : some_directions()) {
        const Frame still = frame_towards(d, 0), turned = frame_towards(d, 0.7);
        for (const Frame& frame : {still, turned}) {
            EXPECT_NEAR(dot(frame.tangent, frame.bitangent), 0, 1e-6);
            EXPECT_NEAR(dot(frame.tangent, frame.normal), 0, 1e-6);
            EXPECT_NEAR(length(frame.tangent), 1, 1e-6);
            EXPECT_NEAR(length(frame.bitangent), 1, 1e-6);
            EXPECT_LT(length(Vec3d(frame.normal) - d), 1e-6);
        }
        EXPECT_NEAR(dot(still.tangent, turned.tangent), std::cos(0.7), 1e-6);
        EXPECT_NEAR(dot(still.bitangent, turned.tangent), std::sin(0.7), 1e-6);
    }
}

TEST(FrameTowards, FollowsARotationAboutY) {
    const double turn = 1.1;
    const Mat3d about_y(Vec3d(std::cos(turn), 0, -std::sin(turn)), Vec3d(0, 1, 0),
                        Vec3d(std::sin(turn), 0, std::cos(turn)));
    for (int i = 0; i < 20; ++i) {
        const Vec3d d = direction_of_lat_long(0.05 * i, (i + 0.5) / 20);
        const Frame frame = frame_towards(d, 0.3), moved = frame_towards(about_y * d, 0.3);
        EXPECT_LT(length(about_y * Vec3d(frame.tangent) - Vec3d(moved.tangent)), 1e-6);
        EXPECT_LT(length(about_y * Vec3d(frame.bitangent) - Vec3d(moved.bitangent)), 1e-6);
    }
}

}  // namespace
}  // namespace splitsum
