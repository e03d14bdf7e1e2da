#include "splitsum/filter/sample_set.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "splitsum/brdf/band_factors.h"

namespace splitsum {
namespace {

constexpr double pi = std::numbers::pi;

double sum_of(const std::vector<float>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

std::vector<Lobe> ggx_lobes() {
    std::vector<Lobe> lobes;
    for (const double alpha : {1e-8, 1e-6, 1e-4, 0.0020, 0.01, 0.09, 0.25, 0.7, 1.0})
        lobes.push_back({LobeKind::ggx, alpha});
    return lobes;
}

// What must hold for every set, however it was made.
void expect_well_formed(const SampleSet& set) {
    ASSERT_EQ(set.x.size() % SampleSet::padding, 0u);
    ASSERT_GE(set.x.size(), set.count);
    ASSERT_LT(set.x.size(), set.count + SampleSet::padding);
    EXPECT_NEAR(sum_of(set.weight), 1, 1e-6);
    for (size_t i = 0; i < set.x.size(); ++i) {
        const double x = set.x[i], y = set.y[i], z = set.z[i];
        ASSERT_NEAR(x * x + y * y + z * z, 1, 3e-7) << i;
        ASSERT_GE(set.weight[i], 0) << i;
        if (i >= set.count) {
            ASSERT_EQ(set.weight[i], 0) << "padding " << i;
            continue;
        }
        ASSERT_GT(set.z[i], 0) << i;
        ASSERT_GT(set.solid_angle[i], 0) << i;
        ASSERT_TRUE(std::isfinite(set.solid_angle[i])) << i;
    }
}

TEST(SampleSet, IsWellFormedForEveryLobeAndCount) {
    for (const int count : {1, 2, 15, 16, 17, 1000})
        for (const Lobe& lobe : ggx_lobes()) {
            SCOPED_TRACE(lobe.alpha);
            expect_well_formed(importance_samples(lobe, count));
        }
    for (const int count : {1, 7, 64, 1000}) {
        expect_well_formed(importance_samples({LobeKind::cosine}, count));
        expect_well_formed(riemann_samples({LobeKind::cosine}, count));
        expect_well_formed(riemann_samples({LobeKind::ggx, 0.5}, count));
    }
}

// Case 2 of the list of failures: widths at which 1 - cos² is rounding noise. The samples' sines are
// compared with the inverse distribution in fp64, written down anew: tan² theta_h = alpha² xi /
// (1 - xi) up to 45 degrees.
TEST(ImportanceSamples, KeepTheirWidthForTinyAlpha) {
    constexpr int count = 512;
    for (const Lobe& lobe : ggx_lobes()) {
        const SampleSet set = importance_samples(lobe, count);
        const double a2 = lobe.alpha * lobe.alpha;
        for (int i = 0; i < count; ++i) {
            const double xi = (i + 0.5) / count / (1 + a2);
            const double theta_l = 2 * std::atan(lobe.alpha * std::sqrt(xi / (1 - xi)));
            const double sine = std::hypot(double(set.x[size_t(i)]), double(set.y[size_t(i)]));
            ASSERT_NEAR(sine, std::sin(theta_l), 3e-7 * std::sin(theta_l))
                << "alpha " << lobe.alpha << " sample " << i;
        }
    }
}

// The solid angles are 1 / (N pdf); they tile the hemisphere where the points cover it.
TEST(ImportanceSamples, CoverTheHemisphere) {
    constexpr int count = 1 << 16;
    for (const double alpha : {0.25, 0.5, 1.0})
        EXPECT_NEAR(sum_of(importance_samples({LobeKind::ggx, alpha}, count).solid_angle), 2 * pi,
                    1e-3)
            << alpha;
    // The cosine's pdf goes to 0 at the horizon like a square root: 1 / sqrt(N) is left out.
    EXPECT_NEAR(sum_of(importance_samples({LobeKind::cosine}, count).solid_angle), 2 * pi, 0.02);
    EXPECT_NEAR(sum_of(riemann_samples({LobeKind::cosine}, count).solid_angle), 2 * pi, 1e-4);
}

// Funk-Hecke along the axis: the weighted mean of P_l(z) is the band factor.
TEST(SampleSet, AveragesLegendrePolynomialsToTheBandFactors) {
    const auto mean_p2 = [](const SampleSet& set) {
        double sum = 0;
        for (size_t i = 0; i < set.count; ++i)
            sum += double(set.weight[i]) * (1.5 * double(set.z[i]) * double(set.z[i]) - 0.5);
        return sum;
    };
    for (const double alpha : {0.01, 0.25, 0.5, 1.0}) {
        const Lobe lobe{LobeKind::ggx, alpha};
        const double expected = band_factors(lobe, 3)[2];
        EXPECT_NEAR(mean_p2(importance_samples(lobe, 4096)), expected, 2e-4) << alpha;
        EXPECT_GT(
            std::abs(mean_p2(importance_samples({LobeKind::ggx, 1.05 * alpha}, 4096)) - expected),
            alpha > 0.1 ? 4e-3 : 4e-5)
            << "a lobe 5 % too wide must show, alpha " << alpha;
    }
    const double cosine = band_factors({LobeKind::cosine}, 3)[2];
    EXPECT_NEAR(mean_p2(importance_samples({LobeKind::cosine}, 4096)), cosine, 1e-4);
    EXPECT_NEAR(mean_p2(riemann_samples({LobeKind::cosine}, 4096)), cosine, 1e-3);
}

}  // namespace
}  // namespace splitsum
