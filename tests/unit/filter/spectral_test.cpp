#include "splitsum/filter/spectral.h"

#include <gtest/gtest.h>

#include <cmath>

#include "splitsum/filter/reference.h"
#include "splitsum/measure/error_figures.h"
#include "splitsum/plan/asset_plan.h"
#include "support/lopsided_sky.h"

namespace splitsum {
namespace {

// Of a streamed panorama the environment is an average only, so that no texel of it may count: here
// it is black. A strong sun and a lobe that just does without being taken apart.
TEST(Spectral, WithASpectrumTheTexelsDoNotMatter) {
    Environment sky = tests::lopsided_sky(24, 50);
    sky.set_texel(5, 7, Vec3(1e7f));
    const Environment black(8);
    const Lobe lobe{LobeKind::ggx, 0.065 * 0.065};
    FilterPlan plan;
    FilterSource kept(sky), streamed(black, kept.tables);
    const auto bands = bands_to_transform(*kept.tables, {&lobe, 1}, plan.accuracy);
    ASSERT_TRUE(bands);
    const Spectrum spectrum = forward_transform(sky, *bands);
    streamed.spectrum = &spectrum;

    std::vector<Vec3d> towards;
    for (int i = 0; i < 50; ++i)
        towards.push_back(direction_of_lat_long(5.5 / 48 + 0.001 * i, 7.5 / 24 + 0.001 * i));
    std::vector<Vec3> a(towards.size()), b(towards.size());
    prepare_spectral(kept, {&lobe, 1}, plan)->evaluate(0, {towards}, a);
    prepare_spectral(streamed, {&lobe, 1}, plan)->evaluate(0, {towards}, b);
    for (size_t i = 0; i < a.size(); ++i) EXPECT_LT(length(a[i] - b[i]), 1e-4f * length(a[0])) << i;
}

// Time and memory of a rough lobe are bounded, whatever shines on it.
TEST(Spectral, ALitTexelInDarknessTakesNoThousandsOfBands) {
    Environment dark(512);
    dark.set_texel(300, 200, Vec3(1e6f, 1e5f, 1e4f));
    const std::vector<Lobe> lobes = {{LobeKind::ggx, 0.4}, {LobeKind::ggx, 1}, {LobeKind::cosine}};
    const auto spectral = prepare_spectral(dark, lobes, {});
    const auto reference = prepare_reference(dark, lobes, {});
    std::vector<Vec3d> towards;
    for (int i = 0; i < 200; ++i)
        towards.push_back(normalize(Vec3d(std::sin(i), std::cos(3 * i), std::sin(7 * i))));
    for (size_t i = 0; i < lobes.size(); ++i) {
        std::vector<Vec3> values(towards.size()), truth(towards.size());
        spectral->evaluate(i, {towards}, values);
        reference->evaluate(i, {towards}, truth);
        EXPECT_LT(error_figures(std::span<const Vec3>(values), truth).rel_rms, 1.2e-4) << i;
        EXPECT_LE(spectral->account(i).bands, 450);
        EXPECT_LT(spectral->account(i).error_bound, 1e-4);
    }
}

TEST(Spectral, LobesThatNeedTheTexelsAreNotTransformedBlindly) {
    FilterTables tables;
    const Lobe sharp{LobeKind::ggx, 1e-4}, rough{LobeKind::ggx, 1}, diffuse{LobeKind::cosine};
    EXPECT_FALSE(bands_to_transform(tables, {&sharp, 1}, 3e-4));
    for (const Lobe& lobe : {rough, diffuse})
        EXPECT_TRUE(bands_to_transform(tables, {&lobe, 1}, 1e-5));
}

}  // namespace
}  // namespace splitsum
