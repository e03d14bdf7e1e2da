#include "splitsum/sphere/area_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/base/random.h"
#include "splitsum/sphere/orientation.h"
#include "support/lopsided_sky.h"

namespace splitsum {
namespace {

Cubemap mirror_image(const Environment& environment, int face_size,
                     const Orientation& orientation = {}) {
    NoProgress progress;
    return *area_filtered_cubemap(environment, face_size, panorama_from_cube(orientation),
                                  progress);
}

// Every texel another value: whatever is taken from the wrong place shows.
Environment noise(int height) {
    Environment sky(height);
    uint32_t key = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < sky.width(); ++x, key += 3)
            sky.set_texel(x, y, Vec3(unit_float(key), unit_float(key + 1), unit_float(key + 2)));
    return sky;
}

Environment one_lit_texel(int height, int x, int y, float radiance) {
    Environment sky(height);
    sky.set_texel(x, y, Vec3(radiance));
    return sky;
}

// The mean over a cube texel of what lies towards points x points of it.
Vec3d mean_of_points(const Environment& sky, const Mat3d& turn, int face, int x, int y,
                     int face_size, int points) {
    Vec3d sum(0);
    for (int j = 0; j < points; ++j)
        for (int i = 0; i < points; ++i) {
            const int fx = points * x + i, fy = points * y + j, fine = face_size * points;
            sum += solid_angle_of_texel(fx, fy, fine) *
                   Vec3d(radiance_towards(sky, turn * direction_of_texel(face, fx, fy, fine)));
        }
    return sum / solid_angle_of_texel(x, y, face_size);
}

double largest_difference(const Environment& sky, int face_size, const Orientation& orientation,
                          int points) {
    const Cubemap mirror = mirror_image(sky, face_size, orientation);
    const Mat3d turn = panorama_from_cube(orientation);
    double worst = 0;
    for (int face = 0; face < face_count; ++face)
        for (int y = 0; y < face_size; ++y)
            for (int x = 0; x < face_size; ++x) {
                const Vec3d mean = mean_of_points(sky, turn, face, x, y, face_size, points);
                worst = std::max(worst, length(mean - Vec3d(mirror.at(face, x, y))));
            }
    return worst;
}

TEST(AreaFilter, KeepsTheMeanForEverySizeEvenOfOneTexelSuns) {
    for (const int height : {1, 2, 5, 32, 200}) {
        Environment sky = tests::lopsided_sky(height, 1e5f);
        sky.set_texel(0, 0, Vec3(1e6f, 0, 0));  // at the poles
        sky.set_texel(1, height - 1, Vec3(0, 0, 1e6f));
        sky.set_texel(sky.width() - 1, height / 2, Vec3(0, 1e6f, 0));  // at the seam
        const Vec3d mean = mean_radiance(sky);
        for (const int size : {1, 2, 3, 16, 33}) {
            const Vec3d filtered = mean_radiance(mirror_image(sky, size, {33, false, "ktx"}));
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(filtered[c], mean[c], 1e-7 * mean[c])
                    << height << " rows, size " << size;
        }
    }
}

TEST(AreaFilter, AConstantStaysConstantToRounding) {
    for (const int height : {1, 9, 64}) {
        const Environment grey =
            tests::environment_of(height, [](const Vec3d&) { return Vec3(0.7f); });
        for (const int size : {1, 2, 5, 64})
            for (const Vec3& texel : mirror_image(grey, size, {12.3, true, "ktx"}).texels)
                ASSERT_NEAR(texel.x, 0.7f, 1e-7f) << height << " rows, size " << size;
    }
}

// The points of the reference fall on either side of a panorama texel's outline: with 100 of them
// along an edge it is good to about 5e-3 (measured: 5.1e-3 at most). Odd heights have columns that no
// quarter turn maps to columns, odd sizes a texel around the pole and one across the equator.
TEST(AreaFilter, EveryTexelIsTheMeanOverItsSolidAngle) {
    const Orientation orientations[] = {{}, {25, true, "khronos-sampler"}, {-133, false, "cmgen"}};
    for (const Orientation& orientation : orientations) {
        EXPECT_LT(largest_difference(noise(16), 4, orientation, 100), 8e-3);
        EXPECT_LT(largest_difference(noise(13), 5, orientation, 100), 8e-3);
        EXPECT_LT(largest_difference(noise(6), 1, orientation, 300), 8e-3);
    }
}

// A sky given as linear function of the direction has the integral of the direction over the texel
// as its mean, here from a fine product rule.
TEST(AreaFilter, ASmoothSkyIsRightToTheSixthDigit) {
    constexpr int size = 8, points = 64;
    const Environment sky =
        tests::environment_of(1024, [](const Vec3d& d) { return Vec3(2 + d.x, 2 + d.y, 2 + d.z); });
    const Cubemap mirror = mirror_image(sky, size);
    for (int face = 0; face < face_count; ++face)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                Vec3d sum(0);
                for (int j = 0; j < points; ++j)
                    for (int i = 0; i < points; ++i) {
                        const int fx = points * x + i, fy = points * y + j;
                        sum += solid_angle_of_texel(fx, fy, size * points) *
                               (2.0 + direction_of_texel(face, fx, fy, size * points));
                    }
                const Vec3d mean = sum / solid_angle_of_texel(x, y, size);
                for (int c = 0; c < 3; ++c)
                    ASSERT_NEAR(mirror.at(face, x, y)[c], mean[c], 1e-5 * mean[c])
                        << "face " << face << " texel " << x << ", " << y;
            }
}

// A texel of the panorama is lit and shared among the cube's texels: each share is right to one
// percent of that texel's light, which is about what the points can tell. In a panorama of 40 rows
// columns are cut into parts, in one of 512 they are not.
struct LitTexel {
    int height, face_size, points;
    int x, y;
};

class OneLitTexel : public testing::TestWithParam<LitTexel> {};

TEST_P(OneLitTexel, IsSharedAmongTexelsByArea) {
    const auto [height, size, points, x, y] = GetParam();
    const Environment sky = one_lit_texel(height, x, y, 1);
    const double light = solid_angle_of_row(y, height);
    const Cubemap mirror = mirror_image(sky, size);
    int shares = 0;
    for (int face = 0; face < face_count; ++face)
        for (int j = 0; j < size; ++j)
            for (int i = 0; i < size; ++i) {
                const double solid_angle = solid_angle_of_texel(i, j, size);
                const double share = mirror.at(face, i, j).x * solid_angle;
                if (std::abs(share) < 1e-6 * light) continue;
                const Vec3d mean = mean_of_points(sky, Mat3d(1), face, i, j, size, points);
                ASSERT_NEAR(share, mean.x * solid_angle, 0.01 * light)
                    << "face " << face << ": " << i << ", " << j;
                ++shares;
            }
    EXPECT_GT(shares, 0);
}

// Around the poles, across a cube's edge, near a corner, on the panorama's seam, at the poles.
INSTANTIATE_TEST_SUITE_P(AreaFilter, OneLitTexel,
                         testing::Values(LitTexel{40, 32, 64, 50, 6}, LitTexel{40, 32, 64, 69, 14},
                                         LitTexel{40, 32, 64, 0, 39}, LitTexel{40, 32, 64, 77, 33},
                                         LitTexel{40, 32, 64, 79, 0},
                                         LitTexel{512, 64, 300, 571, 61},
                                         LitTexel{512, 64, 300, 700, 60},
                                         LitTexel{512, 64, 300, 572, 131},
                                         LitTexel{512, 64, 300, 900, 448}));

// Below a sun F is a million times what a texel holds; around each texel it has to vanish.
TEST(AreaFilter, ASunCastsNoShadow) {
    for (const int height : {64, 65}) {
        const Environment sun = one_lit_texel(height, height / 3, height / 4, 1e6f);
        const Mat3d turn = panorama_from_cube({77, false, "ktx"});
        const Vec3d towards =
            direction_of_lat_long((height / 3 + 0.5) / (2 * height), (height / 4 + 0.5) / height);
        constexpr int size = 33;
        const Cubemap mirror = mirror_image(sun, size, {77, false, "ktx"});
        for (int face = 0; face < face_count; ++face)
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < size; ++x) {
                    const Vec3d direction = turn * direction_of_texel(face, x, y, size);
                    if (dot(direction, towards) > 0.98) continue;
                    ASSERT_NEAR(mirror.at(face, x, y).x, 0, 1e-5)
                        << "face " << face << " texel " << x << ", " << y;
                }
    }
}

}  // namespace
}  // namespace splitsum
