#include "splitsum/verify/probe_texels.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "splitsum/sphere/cubemap.h"

namespace splitsum {
namespace {

TEST(ProbeTexels, AreDifferentTexelsAndAllOfASmallCubemap) {
    for (const int size : {1, 2, 3, 16, 256})
        for (const int count : {0, 1, 2, 8, 24, 64, 1000}) {
            const auto probes = probe_texels(size, count);
            EXPECT_EQ(probes.size(), size_t(std::min(count, 6 * size * size)));
            for (size_t i = 0; i < probes.size(); ++i) {
                const auto [face, x, y] = probes[i];
                EXPECT_TRUE(face >= 0 && face < 6 && x >= 0 && x < size && y >= 0 && y < size);
                EXPECT_EQ(std::ranges::count(probes, probes[i]), 1) << size << " " << count;
            }
        }
}

// No direction is further from the nearest probe than two and a half times what N discs that just
// cover the sphere would leave (their radius is about 2 / sqrt N).
TEST(ProbeTexels, LeaveNoLargePartOfTheSphereOut) {
    for (const int size : {8, 32, 256})
        for (const int count : {8, 64}) {
            double nearest = 1;
            for (int face = 0; face < 6; ++face)
                for (int i = 0; i < 400; ++i) {
                    const Vec3d d = direction_on_face(face, (i % 20) / 19.0, (i / 20) / 19.0);
                    double best = -1;
                    for (const auto [f, x, y] : probe_texels(size, count))
                        best = std::max(best, dot(d, direction_of_texel(f, x, y, size)));
                    nearest = std::min(nearest, best);
                }
            EXPECT_LT(std::acos(nearest), 2.5 * 2 / std::sqrt(count)) << size << " " << count;
            EXPECT_LT(std::acos(nearest), 1.3) << size << " " << count;
        }
}

TEST(ProbeTexels, OfTheLevelsOfAChainLookElsewhere) {
    const auto towards = [](int size) {
        std::vector<Vec3d> directions;
        for (const auto [f, x, y] : probe_texels(size, 8))
            directions.push_back(direction_of_texel(f, x, y, size));
        return directions;
    };
    for (const int size : {256, 128, 64, 32}) {
        double nearest = -1;
        for (const Vec3d& a : towards(size))
            for (const Vec3d& b : towards(size / 2)) nearest = std::max(nearest, dot(a, b));
        EXPECT_LT(nearest, 0.9999) << size;
    }
}

}  // namespace
}  // namespace splitsum
