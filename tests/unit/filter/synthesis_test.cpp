#include "splitsum/filter/synthesis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "splitsum/filter/interpolation.h"
#include "splitsum/math/harmonics.h"

namespace splitsum {
namespace {

// A spectrum with one coefficient, a different one for each channel.
Spectrum one_harmonic(int bands, int l, int m) {
    Spectrum spectrum(bands);
    const auto order = spectrum.order(m);
    const size_t at = size_t(l - m) * 6;
    order[at + 0] = 1;              // red: real part
    order[at + 4] = m > 0 ? 1 : 0;  // green: imaginary part
    order[at + 2] = 0.5;            // blue
    return spectrum;
}

// The panorama's polar axis is y; turned to where math/harmonics.h has its pole.
Vec3d pole_up(const Vec3d& d) { return {d.z, d.x, d.y}; }

Vec3 interpolated(const SphereGrid& grid, const Vec3d& direction) {
    Vec3 value;
    interpolate(grid, {&direction, 1}, {&value, 1});
    return value;
}

TEST(Synthesis, EveryHarmonicComesBackAsItself) {
    constexpr int bands = 24;
    const std::vector<double> factors(bands, 1.0);
    std::vector<double> values(harmonic_count(bands - 1));
    for (const int l : {0, 1, 2, 5, 10})
        for (int m = 0; m <= l; m += std::max(1, l / 3)) {
            const SphereGrid grid = synthesize(one_harmonic(bands, l, m), factors, 8 * bands);
            for (int i = 0; i < 60; ++i) {
                const Vec3d d = direction_of_lat_long(std::fmod(0.618034 * i, 1.0), i / 59.0);
                evaluate_harmonics(pole_up(d), bands - 1, values);
                // a e^(i m phi) and its conjugate: 2 Re, which is sqrt 2 times the real harmonic.
                const double twice = m == 0 ? 1 : std::numbers::sqrt2;
                const Vec3 seen = interpolated(grid, d);
                const double cosine = twice * values[harmonic_index(l, m)];
                const double sine = m == 0 ? 0 : -twice * values[harmonic_index(l, -m)];
                ASSERT_NEAR(seen.x, cosine, 2e-5) << l << " " << m << " at " << i;
                ASSERT_NEAR(seen.y, sine, 2e-5) << l << " " << m << " at " << i;
                ASSERT_NEAR(seen.z, 0.5 * cosine, 2e-5) << l << " " << m << " at " << i;
            }
        }
}

TEST(Synthesis, InterpolationStaysUnderItsStatedError) {
    constexpr int bands = 40, rings = 80;
    const std::vector<double> factors(bands, 1.0);
    for (const int l : {10, 20, 39}) {
        const SphereGrid coarse = synthesize(one_harmonic(bands, l, l / 2), factors, rings);
        const SphereGrid fine = synthesize(one_harmonic(bands, l, l / 2), factors, 16 * rings);
        double error2 = 0, value2 = 0;
        for (int i = 0; i < 2000; ++i) {
            const Vec3d d =
                direction_of_lat_long(std::fmod(0.618034 * i, 1.0),
                                      std::acos(1 - 2 * (i + 0.5) / 2000) / std::numbers::pi);
            const double truth = double(interpolated(fine, d).x);
            error2 += std::pow(double(interpolated(coarse, d).x) - truth, 2);
            value2 += truth * truth;
        }
        EXPECT_LT(std::sqrt(error2 / value2), interpolation_error(l * std::numbers::pi / rings));
    }
}

TEST(Interpolation, ADirectionsValueDoesNotDependOnTheOthers) {
    constexpr int bands = 9;
    const SphereGrid grid =
        synthesize(one_harmonic(bands, 6, 3), std::vector<double>(bands, 1), 32);
    std::vector<Vec3d> towards;
    for (int i = 0; i < 61; ++i)
        towards.push_back(direction_of_lat_long(std::fmod(0.618034 * i, 1.0), i / 60.0));
    for (const size_t count : {1, 7, 8, 9, 61}) {
        std::vector<Vec3> together(count);
        interpolate(grid, std::span(towards).first(count), together);
        for (size_t i = 0; i < count; ++i) EXPECT_EQ(together[i], interpolated(grid, towards[i]));
    }
}

TEST(Interpolation, CubicsAreExactOnEverySideOfTheSphere) {
    // A polynomial of the position on the grid, away from what lies beyond its edges.
    constexpr int rings = 16, columns = 32;
    SphereGrid grid(rings, columns);
    const auto cubic = [](double x, double y) { return 0.01 * x * x * x - y * y + 3 * x * y; };
    for (int ring = -3; ring < rings + 3; ++ring)
        for (int column = -3; column < columns + 3; ++column)
            for (int c = 0; c < 4; ++c)
                grid.point(ring, column)[c] = float(c) * float(cubic(column, ring));
    for (int i = 0; i < 500; ++i) {
        const double u = std::fmod(0.618034 * i, 1.0), v = (i + 0.5) / 500;
        const double truth = cubic(u * columns, v * rings - 0.5);
        EXPECT_NEAR(interpolated(grid, direction_of_lat_long(u, v)).y, truth, 2e-3);
    }
}

}  // namespace
}  // namespace splitsum
