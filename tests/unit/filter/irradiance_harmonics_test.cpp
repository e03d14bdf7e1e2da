#include "splitsum/filter/irradiance_harmonics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/filter/methods.h"
#include "support/lopsided_sky.h"

namespace splitsum {
namespace {

std::vector<Vec3d> many_directions() {
    std::vector<Vec3d> directions;
    for (int i = 0; i < 20000; ++i)
        directions.push_back(direction_of_lat_long(
            std::fmod(0.618034 * i, 1.0), std::acos(1 - (i + 0.5) / 10000) / std::numbers::pi));
    return directions;
}

double lowest_of(const IrradianceHarmonics& harmonics) {
    double lowest = 1e30;
    for (const Vec3d& d : many_directions()) {
        const Vec3d value = evaluate(harmonics, d);
        lowest = std::min({lowest, value.x, value.y, value.z});
    }
    return lowest;
}

Environment one_texel_sun(int x, int y) {
    Environment sky(32);
    sky.set_texel(x, y, Vec3(1e5f));
    return sky;
}

// The bands above 8 carry less than 1e-3 of a smooth sky's irradiance.
TEST(IrradianceHarmonics, OfHighOrderAreTheExactIrradiance) {
    const Environment sky = tests::lopsided_sky(32);
    const IrradianceHarmonics harmonics = irradiance_harmonics(sky, 24, false, Mat3d(1));
    const Lobe cosine{LobeKind::cosine};
    const auto reference = filter_methods()[0].prepare(sky, {&cosine, 1}, {});
    for (int i = 0; i < 20; ++i) {
        const Vec3d d = direction_of_lat_long(std::fmod(0.618034 * i, 1.0), (i + 0.5) / 20);
        Vec3 exact;
        reference->evaluate(0, {{&d, 1}}, {&exact, 1});
        EXPECT_LT(length(evaluate(harmonics, d) - Vec3d(exact)), 1e-3 * length(Vec3d(exact)));
    }
}

TEST(IrradianceHarmonics, KeepTheMeanWithAndWithoutAWindow) {
    const Environment sky = one_texel_sun(3, 9);
    const Vec3d mean = mean_radiance(sky);
    for (const bool windowed : {false, true}) {
        const auto harmonics = irradiance_harmonics(sky, 2, windowed, Mat3d(1));
        const Vec3d found = harmonics.coefficients[0] * std::sqrt(0.25 / std::numbers::pi);
        EXPECT_LT(length(found - mean), 1e-9 * length(mean)) << windowed;
    }
}

// A sun is the worst case: three bands without a window go to -4 % of the peak.
TEST(IrradianceHarmonics, OfASunAreNegativeWithoutAWindowAndNeverWithOne) {
    for (const auto& [x, y] : {std::pair{3, 9}, {0, 0}, {63, 31}, {32, 16}})
        for (const int order : {2, 3, 4, 6}) {
            const Environment sky = one_texel_sun(x, y);
            const double mean = mean_radiance(sky).x;
            const auto plain = irradiance_harmonics(sky, order, false, Mat3d(1));
            if (order % 2 == 0) {
                EXPECT_LT(lowest_of(plain), -0.02 * mean) << order;
                EXPECT_NEAR(lowest_of(plain) / mean, plain.lowest, 1e-3) << order;
            }
            const auto windowed = irradiance_harmonics(sky, order, true, Mat3d(1));
            EXPECT_GT(windowed.window_lambda, 0) << order;
            EXPECT_GE(windowed.lowest, 0) << order;
            EXPECT_GE(lowest_of(windowed), -1e-4 * mean)
                << "sun " << x << " " << y << " order " << order;
        }
}

TEST(IrradianceHarmonics, AreNotDampedWithoutNeed) {
    const Environment sky =
        tests::environment_of(32, [](const Vec3d& d) { return Vec3(2 + d.x, 2 + d.y, 2 + d.z); });
    const auto harmonics = irradiance_harmonics(sky, 2, true, Mat3d(1));
    EXPECT_EQ(harmonics.window_lambda, 0);
    EXPECT_EQ(harmonics.coefficients, irradiance_harmonics(sky, 2, false, Mat3d(1)).coefficients);
}

}  // namespace
}  // namespace splitsum
