#include "splitsum/filter/band_limit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "splitsum/brdf/band_factors.h"
#include "splitsum/filter/reference.h"
#include "splitsum/filter/spectral.h"
#include "splitsum/measure/error_figures.h"
#include "support/lopsided_sky.h"

namespace splitsum {
namespace {

TEST(BandLimit, IsTheSmallestThatKeepsTheBound) {
    const Spectrum spectrum = forward_transform(tests::lopsided_sky(64), 200);
    const std::vector<double> factors = band_factors({LobeKind::ggx, 0.1}, 201);
    const auto left_out = [&](int from) {
        double out = 0, all = 0;
        for (int l = 0; l < 200; ++l) {
            const double power = factors[size_t(l)] * factors[size_t(l)] * spectrum.power(l);
            all += power;
            if (l >= from) out += power;
        }
        return std::sqrt(out / all);
    };
    for (const double accuracy : {1e-2, 1e-3, 1e-4}) {
        const BandLimit limit = band_limit(spectrum, factors, accuracy);
        EXPECT_LE(limit.truncation_bound, accuracy);
        EXPECT_NEAR(limit.truncation_bound, left_out(limit.bands), 1e-2 * accuracy);
        EXPECT_GT(left_out(limit.bands - 1), accuracy);
    }
}

TEST(BandLimit, CountsThePowerThatWasNeverTransformed) {
    // A sun has as much power beyond 20 bands as anywhere: a lobe that needs 60 cannot be done.
    const Environment sun = tests::lopsided_sky(64, 1e6f);
    const Spectrum spectrum = forward_transform(sun, 20);
    const BandLimit limit = band_limit(spectrum, band_factors({LobeKind::ggx, 0.1}, 21), 1e-4);
    EXPECT_EQ(limit.bands, 20);
    EXPECT_GT(limit.truncation_bound, 1e-2);
}

Environment one_texel(int height, float radiance) {
    Environment light(height);
    light.set_texel(height, height / 3, Vec3(radiance));
    return light;
}

// The power that a lit texel has in thousands of bands cannot all be in the next one.
TEST(BandLimit, KnowsHowMuchPowerABandCanHave) {
    const Spectrum all = forward_transform(one_texel(256, 1e3f), 500);
    const Spectrum some = forward_transform(one_texel(256, 1e3f), 50);
    const std::vector<double> factors = band_factors({LobeKind::cosine}, 1000);
    double left_out = 0, kept = 0;
    for (int l = 0; l < 500; ++l)
        (l < 50 ? kept : left_out) += factors[size_t(l)] * factors[size_t(l)] * all.power(l);
    const BandLimit limit = band_limit(some, factors, 1e-5);
    EXPECT_GE(limit.bands, 49);  // odd bands of the cosine are 0
    EXPECT_GT(limit.truncation_bound, std::sqrt(left_out / kept));
    EXPECT_LT(limit.truncation_bound, 1.5 * std::sqrt(left_out / kept));

    // Where light has negative parts it may: there the bound has to be the larger one.
    Environment mixed = one_texel(256, 1e3f);
    mixed.set_texel(7, 100, Vec3(-1e3f));
    EXPECT_GT(band_limit(forward_transform(mixed, 50), factors, 1e-5).truncation_bound,
              5 * limit.truncation_bound);
}

TEST(BandLimit, KeepsNoMoreThanAllowed) {
    const Spectrum spectrum = forward_transform(one_texel(64, 1), 300);
    const std::vector<double> factors = band_factors({LobeKind::ggx, 1}, 301);
    const BandLimit limit = band_limit(spectrum, factors, 1e-6, 50);
    EXPECT_EQ(limit.bands, 50);
    EXPECT_GT(limit.truncation_bound, 1e-6);
    EXPECT_EQ(band_limit(spectrum, factors, 1e-1, 50).bands,
              band_limit(spectrum, factors, 1e-1).bands);
}

TEST(BandLimit, ABlackSkyNeedsOneBand) {
    const Environment black(8);
    EXPECT_EQ(band_limit(forward_transform(black, 4), std::vector<double>(5, 1.0), 1e-4).bands, 1);
}

// The bound that the report prints must hold: over the sphere, for suns of every strength.
TEST(BandLimit, TheErrorOfSpectralIsUnderItsBound) {
    for (const float sun : {0.0f, 1e2f, 1e4f, 1e6f})
        for (const double alpha : {0.02, 0.1, 1.0}) {
            const Environment sky = tests::lopsided_sky(32, sun);
            const Lobe lobe{LobeKind::ggx, alpha};
            const auto spectral = prepare_spectral(sky, {&lobe, 1}, {});
            const auto reference = prepare_reference(sky, {&lobe, 1}, {});
            std::vector<Vec3d> directions;  // evenly over the sphere
            constexpr int count = 500;
            for (int i = 0; i < count; ++i)
                directions.push_back(
                    direction_of_lat_long(std::fmod(0.618034 * i, 1.0),
                                          std::acos(1 - 2 * (i + 0.5) / count) / 3.14159265358979));
            std::vector<Vec3> values(count), truth(count);
            spectral->evaluate(0, {directions}, values);
            reference->evaluate(0, {directions}, truth);
            const double bound = spectral->account(0).error_bound;
            EXPECT_LT(bound, 1e-4);
            EXPECT_LT(error_figures(std::span<const Vec3>(values), truth).rel_rms, 1.2 * bound)
                << "sun " << sun << " alpha " << alpha;
        }
}

}  // namespace
}  // namespace splitsum
