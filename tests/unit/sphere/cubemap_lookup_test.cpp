#include "splitsum/sphere/cubemap_lookup.h"

#include <gtest/gtest.h>

#include <cmath>

namespace splitsum {
namespace {

Cubemap lopsided(int size) {
    Cubemap cubemap(size);
    for (int face = 0; face < face_count; ++face)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                cubemap.at(face, x, y) =
                    Vec3(direction_of_texel(face, x, y, size)) + Vec3(1, 1.5f, 2);
    return cubemap;
}

TEST(CubemapLookup, ReturnsATexelAtItsCentre) {
    for (const int size : {1, 2, 7}) {
        const Cubemap cubemap = lopsided(size);
        for (int face = 0; face < face_count; ++face)
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < size; ++x) {
                    const Vec3 found =
                        bilinear_lookup(cubemap, direction_of_texel(face, x, y, size));
                    EXPECT_LT(length(found - cubemap.at(face, x, y)), 1e-5f);
                }
    }
}

// The map holds its own directions, so that a lookup must return about what it was asked for; a
// neighbour taken from the wrong face is off by up to 2.
TEST(CubemapLookup, HasNoSeamAtEdgesAndCorners) {
    const Cubemap cubemap = lopsided(32);
    for (double a = -1.5; a <= 1.5; a += 0.01)
        for (double b = -1.5; b <= 1.5; b += 0.0625) {
            const Vec3d direction = normalize(Vec3d(a, b, 1));
            const Vec3 found = bilinear_lookup(cubemap, direction) - Vec3(1, 1.5f, 2);
            EXPECT_LT(length(found - Vec3(direction)), 0.04f) << a << " " << b;
        }
}

// Clamping at the edge of a face instead makes a step of half a texel's difference, 0.1 here.
TEST(CubemapLookup, IsContinuousAcrossEveryEdge) {
    const Cubemap cubemap = lopsided(4);
    const auto step = [&](const Vec3d& edge, const Vec3d& across) {
        return length(bilinear_lookup(cubemap, edge + 1e-6 * across) -
                      bilinear_lookup(cubemap, edge - 1e-6 * across));
    };
    for (const double a : {-1.0, 1.0})
        for (const double b : {-1.0, 1.0})
            for (double c = -0.7; c <= 0.7; c += 0.1) {
                EXPECT_LT(step({a, b, c}, {1, 0, 0}), 1e-4f);
                EXPECT_LT(step({a, c, b}, {1, 0, 0}), 1e-4f);
                EXPECT_LT(step({c, a, b}, {0, 1, 0}), 1e-4f);
            }
}

// Towards a corner all three faces must say the same: the mean of the three texels that meet there.
TEST(CubemapLookup, IsTheMeanOfThreeTexelsAtACorner) {
    const Cubemap cubemap = lopsided(4);
    const Vec3 mean =
        (cubemap.at(0, 0, 0) + cubemap.at(2, 3, 3) + cubemap.at(4, 3, 0)) / 3.0f;  // +X +Y +Z
    for (const Vec3d& nudge : {Vec3d(1e-7, 0, 0), Vec3d(0, 1e-7, 0), Vec3d(0, 0, 1e-7)})
        EXPECT_LT(length(bilinear_lookup(cubemap, Vec3d(1, 1, 1) + nudge) - mean), 1e-5f);
}

}  // namespace
}  // namespace splitsum
