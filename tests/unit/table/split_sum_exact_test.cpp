#include "splitsum/table/split_sum_exact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "splitsum/brdf/ggx.h"
#include "splitsum/math/quadrature.h"

namespace splitsum {
namespace {

constexpr double alphas[] = {1e-6, 1e-3, 0.01, 0.1, 0.3, 0.7, 1};
constexpr double cosines[] = {0, 1e-4, 1e-3, 0.02, 0.3, 0.71, 0.99, 1};

// Another road: over light directions with plain vectors, the way the BRDF is usually written down.
// The panels are uniform, so it needs a wide lobe.
SplitSum over_light_directions(SmithTerm term, double n_dot_v, double alpha) {
    const QuadratureRule rule = gauss_legendre(20);
    const Vec3d view(std::sqrt(1 - n_dot_v * n_dot_v), 0, n_dot_v);
    const Vec3d normal(0, 0, 1);
    SplitSum sum{0, 0};
    const auto add = [&](double theta, double phi, double weight) {
        const Vec3d light(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                          std::cos(theta));
        const Vec3d half = normalize(light + view);
        const Vec3d across = cross(normal, half);
        const double f = ggx_density(dot(across, across), alpha) *
                         smith_visibility(term, light.z, n_dot_v, alpha) * light.z;
        const double fresnel = std::pow(1 - dot(view, half), 5);
        sum.a += weight * std::sin(theta) * (1 - fresnel) * f;
        sum.b += weight * std::sin(theta) * fresnel * f;
    };
    constexpr int panels = 16;
    const double theta_step = 0.5 * std::numbers::pi / panels;
    const double phi_step = std::numbers::pi / panels;
    for (int i = 0; i < panels; ++i)
        for (int j = 0; j < panels; ++j)
            for (size_t p = 0; p < rule.nodes.size(); ++p)
                for (size_t q = 0; q < rule.nodes.size(); ++q)
                    add((i + 0.5 + 0.5 * rule.nodes[p]) * theta_step,
                        (j + 0.5 + 0.5 * rule.nodes[q]) * phi_step,
                        0.5 * theta_step * phi_step * rule.weights[p] * rule.weights[q]);
    return sum;
}

TEST(SplitSumExact, DoesNotDependOnTheOrderOfTheRule) {
    for (const SmithTermInfo& info : smith_terms())
        for (const double alpha : alphas)
            for (const double n_dot_v : cosines) {
                const SplitSum low = split_sum_exact(info.term, n_dot_v, alpha);
                const SplitSum high = split_sum_exact(info.term, n_dot_v, alpha, 16);
                EXPECT_NEAR(low.a, high.a, 1e-9) << info.name << " " << alpha << " " << n_dot_v;
                EXPECT_NEAR(low.b, high.b, 1e-9) << info.name << " " << alpha << " " << n_dot_v;
            }
}

TEST(SplitSumExact, AgreesWithAnIntegrationOverLightDirections) {
    for (const SmithTermInfo& info : smith_terms())
        for (const double alpha : {0.2, 0.5, 1.0})
            for (const double n_dot_v : {0.05, 0.4, 0.9}) {
                const SplitSum exact = split_sum_exact(info.term, n_dot_v, alpha);
                const SplitSum other = over_light_directions(info.term, n_dot_v, alpha);
                EXPECT_NEAR(exact.a, other.a, 1e-7) << info.name << " " << alpha << " " << n_dot_v;
                EXPECT_NEAR(exact.b, other.b, 1e-7) << info.name << " " << alpha << " " << n_dot_v;
            }
}

// A surface of height-correlated Smith loses only what bounces again: 1 where it is smooth, less
// where it is rough, never more.
TEST(SplitSumExact, ReflectsNoMoreThanItReceives) {
    for (const double n_dot_v : cosines) {
        double previous = 1 + 1e-9;
        for (const double alpha : alphas) {
            const SplitSum sum = split_sum_exact(SmithTerm::height_correlated, n_dot_v, alpha);
            if (n_dot_v >= 0.3) {
                EXPECT_LE(sum.a + sum.b, previous) << alpha << " " << n_dot_v;
            }
            EXPECT_LE(sum.a + sum.b, 1 + 1e-9);
            EXPECT_GT(sum.a, 0);
            EXPECT_GE(sum.b, 0);
            previous = sum.a + sum.b;
        }
    }
}

// At alpha = 1 the facets face all ways alike: D = 1 / pi and V = 1 / (2 (n·l + n·v)), so that
//     a + b = ∫ x / (x + n·v) dx over [0, 1] = 1 - n·v ln((1 + n·v) / n·v).
TEST(SplitSumExact, HasAClosedFormForTheRoughestSurface) {
    for (const double n_dot_v : cosines) {
        const SplitSum sum = split_sum_exact(SmithTerm::height_correlated, n_dot_v, 1);
        const double lost = n_dot_v > 0 ? n_dot_v * std::log((1 + n_dot_v) / n_dot_v) : 0;
        EXPECT_NEAR(sum.a + sum.b, 1 - lost, 1e-10) << n_dot_v;
    }
}

TEST(SplitSumExact, OfTheMirrorIsFresnel) {
    for (const SmithTermInfo& info : smith_terms())
        for (const double n_dot_v : cosines) {
            const SplitSum mirror = split_sum_exact(info.term, n_dot_v, 0);
            EXPECT_NEAR(mirror.b, std::pow(1 - n_dot_v, 5), 1e-15);
            EXPECT_NEAR(mirror.a + mirror.b, 1, 1e-15);
            if (n_dot_v < 0.02) continue;
            const SplitSum nearly = split_sum_exact(info.term, n_dot_v, 1e-6);
            EXPECT_NEAR(nearly.a, mirror.a, 2e-4) << info.name << " " << n_dot_v;
            EXPECT_NEAR(nearly.b, mirror.b, 2e-4) << info.name << " " << n_dot_v;
        }
}

}  // namespace
}  // namespace splitsum
