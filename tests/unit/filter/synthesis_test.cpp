#include "splitsum/filter/synthesis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

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
                const Vec3 seen = interpolate(grid, d);
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
            const double truth = double(interpolate(fine, d).x);
            error2 += std::pow(double(interpolate(coarse, d).x) - truth, 2);
            value2 += truth * truth;
        }
        EXPECT_LT(std::sqrt(error2 / value2), interpolation_error(l * std::numbers::pi / rings));
    }
}

}  // namespace
}  // namespace splitsum
