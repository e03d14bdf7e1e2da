// A filter is a product in harmonic space. The coefficients here come from sums over texels without
// an FFT, the factors from quadrature, the harmonics from their recurrence: nothing is shared with
// what they judge.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "splitsum/brdf/band_factors.h"
#include "splitsum/filter/harmonics_of_environment.h"
#include "splitsum/filter/methods.h"
#include "splitsum/math/harmonics.h"
#include "splitsum/math/quadrature.h"
#include "splitsum/plan/asset_plan.h"
#include "support/lopsided_sky.h"

namespace splitsum {
namespace {

constexpr double pi = std::numbers::pi;

std::unique_ptr<PreparedFilter> prepared(const std::string& method, const Environment& sky,
                                         const Lobe& lobe, double accuracy) {
    FilterPlan plan;
    plan.method = method;
    plan.accuracy = accuracy;
    return find_filter_method(method, lobe.kind)->prepare(sky, {&lobe, 1}, plan);
}

class HarmonicSpace : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Methods, HarmonicSpace, testing::Values("reference", "spectral"),
                         [](const auto& test) { return test.param; });

// Harmonics of bands up to 64, one or two a channel, each as strong as the others.
Environment sky_of_harmonics() {
    constexpr int order = 64;
    std::vector<double> values(harmonic_count(order));
    return tests::environment_of(256, [&](const Vec3d& d) {
        evaluate_harmonics(d, order, values);
        const auto y = [&](int l, int m) { return values[harmonic_index(l, m)]; };
        return Vec3(1.0 + Vec3d(y(1, -1) + y(5, 3) + y(40, -17), y(2, 1) + y(13, -13) + y(55, 8),
                                y(3, 0) + y(21, 20) + y(64, 31)));
    });
}

TEST_P(HarmonicSpace, BandsUpTo64AreScaledByTheirFactors) {
    constexpr int order = 128;  // a grid of texels puts some power above 64
    const Environment sky = sky_of_harmonics();
    const auto coefficients = harmonics_of_environment(sky, order, Mat3d(1));
    std::vector<double> values(harmonic_count(order));
    for (const Lobe& lobe : {Lobe{LobeKind::ggx, 0.06}, Lobe{LobeKind::ggx, 0.3}}) {
        const auto k = band_factors(lobe, order + 1);
        const auto filter = prepared(GetParam(), sky, lobe, 1e-5);
        double error2 = 0, value2 = 0;
        for (int i = 0; i < 60; ++i) {
            const Vec3d d = direction_of_lat_long(std::fmod(0.137 + 0.618034 * i, 1.0), i / 59.0);
            Vec3 seen;
            filter->evaluate(0, {{&d, 1}}, {&seen, 1});
            evaluate_harmonics(d, order, values);
            Vec3d expected(0);
            for (int l = 0; l <= order; ++l)
                for (int m = -l; m <= l; ++m)
                    expected += k[size_t(l)] * values[harmonic_index(l, m)] *
                                coefficients[harmonic_index(l, m)];
            error2 += dot(Vec3d(seen) - expected, Vec3d(seen) - expected);
            value2 += dot(expected, expected);
        }
        EXPECT_LT(std::sqrt(error2 / value2), 1e-6) << "alpha " << lobe.alpha;
    }
}

// Over the sphere, not over texels: the mean of a few texels is not that of the level.
TEST_P(HarmonicSpace, MeanRadianceStays) {
    const bool slow = GetParam() == "reference";
    const Environment sky = tests::lopsided_sky(slow ? 24 : 128, 1e5f);
    const Vec3d mean = mean_radiance(sky);
    for (const Lobe& lobe : {Lobe{LobeKind::ggx, slow ? 0.5 : 0.03}, Lobe{LobeKind::ggx, 1},
                             Lobe{LobeKind::cosine, 1}}) {
        const auto filter = prepared(GetParam(), sky, lobe, 3e-4);
        // Exact for as many bands as there are rings, and circles of twice as many points.
        const QuadratureRule rule = gauss_legendre(slow ? 24 : 200);
        const int points = int(2 * rule.nodes.size());
        Vec3d sum(0);
        std::vector<Vec3d> towards(size_t(points), Vec3d(0));
        std::vector<Vec3> seen(towards.size());
        for (size_t ring = 0; ring < rule.nodes.size(); ++ring) {
            for (int j = 0; j < points; ++j)
                towards[size_t(j)] =
                    direction_of_lat_long((j + 0.5) / points, std::acos(rule.nodes[ring]) / pi);
            filter->evaluate(0, {towards}, seen);
            for (const Vec3& value : seen) sum += 0.5 * rule.weights[ring] / points * Vec3d(value);
        }
        const double tolerance = slow ? 1e-4 : 1e-6;  // bands above 24 are left of a sun
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(sum[c] / mean[c], 1, tolerance) << "alpha " << lobe.alpha;
    }
}

}  // namespace
}  // namespace splitsum
