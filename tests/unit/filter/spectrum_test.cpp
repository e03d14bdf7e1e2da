#include "splitsum/filter/spectrum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "splitsum/filter/harmonics_of_environment.h"
#include "splitsum/math/harmonics.h"
#include "support/lopsided_sky.h"

namespace splitsum {
namespace {

// Another derivation of the same coefficients: sums over texels without an FFT, Gauss points enough
// for 1e-12, and real harmonics. About the panorama's own pole they differ by a factor sqrt 2 and
// the sign of the sine only; here the power of each band is compared, which no rotation changes.
TEST(Spectrum, PowerOfEachBandIsThatOfTheDirectSum) {
    for (const int height : {5, 16, 33}) {
        const Environment sky = tests::lopsided_sky(height);
        constexpr int order = 12;
        const auto direct = harmonics_of_environment(sky, order, Mat3d(1));
        const Spectrum spectrum = forward_transform(sky, order + 1);
        for (int l = 0; l <= order; ++l) {
            double power = 0;
            for (int m = -l; m <= l; ++m) {
                const Vec3d& c = direct[harmonic_index(l, m)];
                power += dot(c, c);
            }
            EXPECT_NEAR(spectrum.power(l), power, 1e-5 * power + 1e-9 * spectrum.total_power())
                << "band " << l << " of " << height << " rows";
        }
    }
}

TEST(Spectrum, PowerAddsUpToTheIntegralOfTheSquare) {
    const Environment smooth = tests::environment_of(
        64, [](const Vec3d& d) { return Vec3(Vec3d(1 + d.x * d.y, 2 + d.z, 1 + d.y * d.z)); });
    const Spectrum spectrum = forward_transform(smooth, 600);
    double sum = 0;
    for (int l = 0; l < spectrum.bands(); ++l) {
        EXPECT_GE(spectrum.power(l), 0);
        sum += spectrum.power(l);
    }
    // A piecewise-constant function has some power at any band: the steps between texels.
    EXPECT_NEAR(sum / spectrum.total_power(), 1, 1e-5);
    EXPECT_LE(sum, spectrum.total_power() * (1 + 1e-6));
}

TEST(Spectrum, FirstCoefficientIsTheMean) {
    const Environment sky = tests::lopsided_sky(40, 1e6f);
    const Spectrum spectrum = forward_transform(sky, 3);
    const Vec3d mean = mean_radiance(sky);
    for (int c = 0; c < 3; ++c) {
        const double from_band_0 = spectrum.order(0)[size_t(c)] / std::sqrt(4 * std::numbers::pi);
        EXPECT_NEAR(from_band_0 / mean[c], 1, 1e-6);
    }
}

// Of two spectra, the largest difference of a coefficient of band l, relative to the environment.
double difference(const Spectrum& a, const Spectrum& b, int l) {
    double largest = 0;
    for (int m = 0; m <= l; ++m)
        for (size_t c = 0; c < 6; ++c) {
            const size_t at = size_t(l - m) * 6 + c;
            largest = std::max(largest, std::abs(a.order(m)[at] - b.order(m)[at]));
        }
    return largest / std::sqrt(a.total_power());
}

TEST(Spectrum, ManyRowsGatheredOnRingsGiveTheSameCoefficients) {
    // 24 bands of 288 or 301 rows are gathered on 72 rings, 80 bands are not. A sun near each pole.
    for (const int height : {288, 301}) {
        Environment sky = tests::lopsided_sky(height, 1e5f);
        sky.set_texel(7, 0, Vec3(1e5f, 2e5f, 3e5f));
        sky.set_texel(height + 1, height - 2, Vec3(3e5f, 1e5f, 0));
        const Spectrum gathered = forward_transform(sky, 24), direct = forward_transform(sky, 80);
        for (int l = 0; l < 24; ++l) {
            const double angle = l * std::numbers::pi / 72;
            EXPECT_LT(difference(gathered, direct, l), 2e-7 + 1.1e-3 * std::pow(angle, 8))
                << "band " << l << " of " << height << " rows";
        }
        EXPECT_EQ(gathered.total_power(), direct.total_power());
    }
}

TEST(Spectrum, DoesNotDependOnHowTheRowsArrive) {
    constexpr int height = 300, bands = 20;
    const Environment sky = tests::lopsided_sky(height, 1e5f);
    const Spectrum whole = forward_transform(sky, bands);
    for (const int band : {1, 7, 64, 100}) {  // rings: any number does
        SpectrumBuilder builder(height, bands);
        for (int row = 0; row < height; row += band)
            builder.add_rows(std::min(band, height - row),
                             sky.texels().data() + size_t(row) * 4 * size_t(sky.width()), 4);
        const Spectrum streamed = builder.finish();
        for (int l = 0; l < bands; ++l) ASSERT_EQ(difference(streamed, whole, l), 0) << band;
    }
}

}  // namespace
}  // namespace splitsum
