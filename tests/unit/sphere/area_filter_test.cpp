#include "splitsum/sphere/area_filter.h"

#include <gtest/gtest.h>

#include <numbers>

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

TEST(AreaFilter, KeepsTheMeanForEverySizeEvenOfOneTexelSuns) {
    for (const int height : {1, 2, 5, 32, 200}) {
        Environment sky = tests::lopsided_sky(height, 1e5f);
        sky.set_texel(0, 0, Vec3(1e6f, 0, 0));                         // at the pole
        sky.set_texel(sky.width() - 1, height / 2, Vec3(0, 1e6f, 0));  // at the seam
        const Vec3d mean = mean_radiance(sky);
        for (const int size : {1, 2, 3, 16, 33}) {
            const Vec3d filtered = mean_radiance(mirror_image(sky, size));
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(filtered[c], mean[c], 1e-6 * mean[c])
                    << height << " rows, size " << size;
        }
    }
}

TEST(AreaFilter, AConstantStaysConstantToRounding) {
    const Environment grey = tests::environment_of(9, [](const Vec3d&) { return Vec3(0.7f); });
    for (const int size : {1, 2, 5, 64})
        for (const Vec3& texel : mirror_image(grey, size).texels)
            ASSERT_NEAR(texel.x, 0.7f, 1e-7f) << "size " << size;
}

TEST(AreaFilter, EveryTexelIsTheMeanOverItsSolidAngle) {
    const Environment sky = tests::lopsided_sky(24, 5);
    const Orientation orientation{25, true, "khronos-sampler"};
    const Mat3d turn = panorama_from_cube(orientation);
    constexpr int size = 6, points = 100;
    const Cubemap mirror = mirror_image(sky, size, orientation);
    for (int face = 0; face < face_count; ++face)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                Vec3d sum(0);
                for (int j = 0; j < points; ++j)
                    for (int i = 0; i < points; ++i) {
                        const int fx = points * x + i, fy = points * y + j;
                        const Vec3d d = direction_of_texel(face, fx, fy, size * points);
                        sum += solid_angle_of_texel(fx, fy, size * points) *
                               Vec3d(radiance_towards(sky, turn * d));
                    }
                const Vec3d mean = sum / solid_angle_of_texel(x, y, size);
                // The sun's outline falls between the points of this sum.
                ASSERT_LT(length(mean - Vec3d(mirror.at(face, x, y))), 0.02 + 2e-3 * length(mean))
                    << "face " << face << " texel " << x << ", " << y;
            }
}

}  // namespace
}  // namespace splitsum
