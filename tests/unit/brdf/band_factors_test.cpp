#include "splitsum/brdf/band_factors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "splitsum/math/quadrature.h"

namespace splitsum {
namespace {

Lobe ggx_lobe(double alpha) { return {LobeKind::ggx, alpha}; }

// Ramamoorthi & Hanrahan 2001, eq. 19, divided by pi.
double clamped_cosine_factor(int l) {
    if (l == 1) return 2.0 / 3;
    if (l % 2 == 1) return 0;
    double factor = 1;  // l! / (2^l ((l/2)!)²), one pair of numbers at a time
    for (int k = 1; k <= l / 2; ++k) factor *= (2.0 * k - 1) / (2.0 * k);
    const double sign = (l / 2) % 2 == 1 ? 1 : -1;
    return 2 * sign * factor / ((l + 2.0) * (l - 1.0));
}

// Another road to k_l: the GGX distribution is integrated by its own inverse distribution function
// xi, so that K dc becomes c d(xi), and the Legendre polynomials come from the standard library.
double ggx_factor_by_inversion(double alpha, int l) {
    const double alpha2 = alpha * alpha;
    const auto versine = [=](double xi) { return 2 * alpha2 * xi / (1 - xi * (1 - alpha2)); };
    const double last_xi = 0.5 / (alpha2 + 0.5 * (1 - alpha2));
    const QuadratureRule rule = gauss_legendre(48);
    double weight_sum = 0;
    double sum = 0;
    // Panels shrink towards the horizon, where the angle runs fastest.
    for (int panel = 0; panel < 640; ++panel) {
        const double from = last_xi * (1 - std::exp2(-panel / 16.0));
        const double to = last_xi * (1 - std::exp2(-(panel + 1) / 16.0));
        weight_sum += integrate(rule, from, to, [&](double xi) { return 1 - versine(xi); });
        sum += integrate(rule, from, to, [&](double xi) {
            const double c = std::max(0.0, 1 - versine(xi));
            return c * std::legendre(static_cast<unsigned>(l), c);
        });
    }
    return sum / weight_sum;
}

TEST(BandFactors, OfTheCosineAreTheClosedForm) {
    const auto k = band_factors({LobeKind::cosine, 1}, 1000);
    for (int l = 0; l < 1000; ++l)
        EXPECT_NEAR(k[static_cast<size_t>(l)], clamped_cosine_factor(l), 1e-12) << "band " << l;
}

TEST(BandFactors, OfGgxAgreeWithAnotherIntegration) {
    for (const double alpha : {1.0, 0.6, 0.25, 0.09, 0.01}) {
        const auto k = band_factors(ggx_lobe(alpha), 301);
        for (const int l : {0, 1, 2, 3, 10, 31, 100, 300})
            EXPECT_NEAR(k[static_cast<size_t>(l)], ggx_factor_by_inversion(alpha, l), 2e-12)
                << "alpha " << alpha << ", band " << l;
    }
}

TEST(BandFactors, DoNotDependOnHowManyAreAsked) {
    const auto few = band_factors(ggx_lobe(0.04), 10);
    const auto many = band_factors(ggx_lobe(0.04), 1200);
    for (size_t l = 0; l < few.size(); ++l) EXPECT_NEAR(few[l], many[l], 1e-13);
}

TEST(BandFactors, StartAtOneAndNeverExceedIt) {
    for (const double alpha : {1.0, 0.3, 1e-2, 1e-4, 1e-6, 1e-20}) {
        const auto k = band_factors(ggx_lobe(alpha), 500);
        EXPECT_EQ(k[0], 1);
        for (const double factor : k) EXPECT_LE(std::abs(factor), 1 + 1e-12) << alpha;
    }
}

TEST(BandFactors, OfTheMirrorAreOne) {
    for (const double alpha : {0.0, 1e-200, 1e-14})
        for (const double factor : band_factors(ggx_lobe(alpha), 100))
            EXPECT_NEAR(factor, 1, 1e-13);
}

// A narrow lobe is flat: its factors are the Hankel transform of alpha² / (alpha² + theta² / 4)²,
// which is x K_1(x) with x = 2 alpha (l + 1/2). It decays like sqrt(pi x / 2) exp(-x).
TEST(BandFactors, OfNarrowLobesAreABesselFunction) {
    constexpr double alpha = 1e-3;
    const auto k = band_factors(ggx_lobe(alpha), 2000);
    for (const size_t l : {10, 100, 500, 1000, 1999}) {
        const double x = 2 * alpha * (static_cast<double>(l) + 0.5);
        EXPECT_NEAR(k[l], x * std::cyl_bessel_k(1, x), 1e-4) << "band " << l;
    }
}

// Lobes filtered one after the other multiply, so a wider lobe keeps less of every low band.
TEST(BandFactors, FallWithTheWidth) {
    double previous = 1;
    for (const double alpha : {1e-3, 1e-2, 0.05, 0.2, 0.5, 1.0}) {
        const double k2 = band_factors(ggx_lobe(alpha), 3)[2];
        EXPECT_LT(k2, previous) << alpha;
        previous = k2;
    }
}

// The first band from which no factor reaches 1e-4, as the plan for the transform's size uses it.
TEST(BandFactors, EndWhereThePlanExpects) {
    const struct {
        double perceptual_roughness;
        int limit;
    } cases[] = {{1, 46}, {0.5, 22}, {0.3, 58}, {0.2, 132}, {0.15, 236}, {0.1, 532}};
    for (const auto& [perceptual_roughness, limit] : cases) {
        const auto k = band_factors(ggx_lobe(perceptual_roughness * perceptual_roughness), 700);
        int last = 0;
        for (int l = 0; l < 700; ++l)
            if (std::abs(k[static_cast<size_t>(l)]) >= 1e-4) last = l;
        EXPECT_EQ(last, limit) << "perceptual roughness " << perceptual_roughness;
    }
}

}  // namespace
}  // namespace splitsum
