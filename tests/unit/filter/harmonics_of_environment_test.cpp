#include "splitsum/filter/harmonics_of_environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "splitsum/base/parallel.h"
#include "splitsum/math/harmonics.h"
#include "splitsum/sphere/orientation.h"
#include "support/lopsided_sky.h"

namespace splitsum {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int order = 8;

// The sky Y_i in three channels, seen at texel centres.
Environment sky_of_harmonics(int height, const std::array<size_t, 3>& which) {
    return tests::environment_of(height, [&](const Vec3d& d) {
        std::vector<double> values(harmonic_count(order));
        evaluate_harmonics(d, order, values);
        return Vec3(float(values[which[0]]), float(values[which[1]]), float(values[which[2]]));
    });
}

// The harmonics are orthonormal: a sky Y_i has the coefficients of a unit vector. A texel's mean
// differs from the value in its middle by (l h)² / 24 with h = pi / 128: 1.6e-3 for band 8.
TEST(HarmonicsOfEnvironment, OfAHarmonicAreAUnitVector) {
    for (size_t i = 0; i < harmonic_count(order); i += 3) {
        const std::array<size_t, 3> which = {i, std::min(i + 1, harmonic_count(order) - 1),
                                             std::min(i + 2, harmonic_count(order) - 1)};
        const auto found = harmonics_of_environment(sky_of_harmonics(128, which), order, Mat3d(1));
        ASSERT_EQ(found.size(), harmonic_count(order));
        for (size_t k = 0; k < found.size(); ++k)
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(found[k][c], k == which[size_t(c)] ? 1 : 0, 2e-3)
                    << "sky " << which[size_t(c)] << " coefficient " << k;
    }
}

TEST(HarmonicsOfEnvironment, EveryOrderIsTheBeginningOfTheNext) {
    const Environment sky = tests::lopsided_sky(24);
    const auto longest = harmonics_of_environment(sky, order, Mat3d(1));
    for (int shorter = 0; shorter < order; ++shorter) {
        const auto found = harmonics_of_environment(sky, shorter, Mat3d(1));
        ASSERT_EQ(found.size(), harmonic_count(shorter));
        for (size_t k = 0; k < found.size(); ++k)
            EXPECT_LT(length(found[k] - longest[k]), 1e-11) << shorter << " " << k;
    }
}

// Exact for a piecewise-constant sky: one texel of radiance 1 gives ∫ Y over that texel, here by a
// fine grid of points.
TEST(HarmonicsOfEnvironment, OfOneTexelAreItsIntegrals) {
    constexpr int height = 4, points = 400;
    for (const auto& [x, y] : {std::pair{5, 1}, {0, 0}, {7, 3}}) {
        Environment sky(height);
        sky.set_texel(x, y, Vec3(1));
        const auto found = harmonics_of_environment(sky, order, Mat3d(1));
        std::vector<double> expected(harmonic_count(order), 0), values(harmonic_count(order));
        for (int j = 0; j < points; ++j)
            for (int i = 0; i < points; ++i) {
                const double v = (y + (j + 0.5) / points) / height;
                const Vec3d d = direction_of_lat_long((x + (i + 0.5) / points) / (2 * height), v);
                evaluate_harmonics(d, order, values);
                const double area = std::sin(pi * v) * pi / height * pi / height / points / points;
                for (size_t k = 0; k < values.size(); ++k) expected[k] += area * values[k];
            }
        for (size_t k = 0; k < values.size(); ++k)
            EXPECT_NEAR(found[k].y, expected[k], 3e-6) << x << " " << y << " " << k;
    }
}

// The series in the cube's axes has, towards a cube direction, the value that the panorama's own
// series has where that direction points to.
TEST(HarmonicsOfEnvironment, FollowTheOrientation) {
    const Environment sky = tests::lopsided_sky(24);
    const auto straight = harmonics_of_environment(sky, order, Mat3d(1));
    for (const Orientation& orientation :
         {Orientation{30, false, "ktx"}, Orientation{-110, true, "ktx"},
          Orientation{0, false, "khronos-sampler"}, Orientation{77, true, "cmgen"}}) {
        const Mat3d panorama_from_cube = splitsum::panorama_from_cube(orientation);
        const auto turned = harmonics_of_environment(sky, order, panorama_from_cube);
        std::vector<double> here(harmonic_count(order)), there(harmonic_count(order));
        for (int i = 0; i < 30; ++i) {
            const Vec3d d = direction_of_lat_long(std::fmod(0.618034 * i, 1.0), (i + 0.5) / 30);
            evaluate_harmonics(d, order, here);
            evaluate_harmonics(panorama_from_cube * d, order, there);
            Vec3d in_cube(0), in_panorama(0);
            for (size_t k = 0; k < here.size(); ++k) {
                in_cube += here[k] * turned[k];
                in_panorama += there[k] * straight[k];
            }
            EXPECT_LT(length(in_cube - in_panorama), 1e-10) << orientation.convention;
        }
    }
}

TEST(HarmonicsOfEnvironment, DoNotDependOnTheNumberOfThreads) {
    const Environment sky = tests::lopsided_sky(50);
    const auto with_threads = [&](int threads) {
        const ThreadLimit limit(threads);
        return harmonics_of_environment(sky, 4, Mat3d(1));
    };
    EXPECT_EQ(with_threads(1), with_threads(7));
}

}  // namespace
}  // namespace splitsum
