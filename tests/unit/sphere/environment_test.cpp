#include "splitsum/sphere/environment.h"

#include <gtest/gtest.h>

#include <numbers>

#include "support/lopsided_sky.h"

namespace splitsum {
namespace {

TEST(Environment, RowsCoverTheSphere) {
    for (const int height : {1, 2, 3, 512, 16384}) {
        double sum = 0;
        for (int y = 0; y < height; ++y) sum += 2 * height * solid_angle_of_row(y, height);
        EXPECT_NEAR(sum, 4 * std::numbers::pi, 1e-11) << "height " << height;
    }
}

TEST(Environment, LatLongInvertsDirections) {
    for (const double u : {0.0, 0.1, 0.5, 0.9999})
        for (const double v : {1e-9, 0.2, 0.5, 1 - 1e-9}) {
            const LatLong at = lat_long_towards(direction_of_lat_long(u, v));
            EXPECT_NEAR(at.u, u, 1e-15);
            EXPECT_NEAR(at.v, v, 1e-15);
        }
}

TEST(Environment, LookupsFindTheTexelOnBothSidesOfTheSeam) {
    const Environment sky = tests::lopsided_sky(8);
    const auto at = [&](double u, double v) {
        return radiance_towards(sky, direction_of_lat_long(u, v));
    };
    EXPECT_EQ(at(1e-6, 0.5), sky.texel(0, 4));
    EXPECT_EQ(at(1 - 1e-6, 0.5), sky.texel(15, 4));
    EXPECT_EQ(at(0.51, 0.0), sky.texel(8, 0));
    EXPECT_EQ(at(0.51, 1.0), sky.texel(8, 7));
}

TEST(Environment, AveragingDownKeepsTheMeanForEveryRatio) {
    const Environment sky = tests::lopsided_sky(60);
    const Vec3d mean = mean_radiance(sky);
    for (const int height : {60, 59, 31, 30, 7, 2, 1})
        EXPECT_LT(length(mean_radiance(averaged_down(sky, height)) - mean), 3e-7 * length(mean))
            << "to " << height << " rows";
}

TEST(Environment, AveragingDownWeighsRowsBySolidAngle) {
    // One lit row next to the pole: its share of the two rows' solid angle, not one half.
    Environment rows(4);
    for (int x = 0; x < 8; ++x) rows.set_texel(x, 0, Vec3(1));
    const double share =
        solid_angle_of_row(0, 4) / (solid_angle_of_row(0, 4) + solid_angle_of_row(1, 4));
    EXPECT_NEAR(averaged_down(rows, 2).texel(1, 0).x, share, 1e-7);
}

}  // namespace
}  // namespace splitsum
