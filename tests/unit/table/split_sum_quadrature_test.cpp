#include "splitsum/table/split_sum_quadrature.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/base/parallel.h"
#include "splitsum/table/half_vector_rules.h"
#include "splitsum/table/split_sum_exact.h"

namespace splitsum {
namespace {

// From where a lobe is a needle to where it is the hemisphere, from edge on to straight down.
constexpr double alphas[] = {1e-9, 3e-7, 1e-5, 1e-3, 0.013, 0.1, 0.37, 0.71, 1};
constexpr double cosines[] = {0, 1e-7, 1e-4, 3e-3, 0.02, 0.3, 0.71, 0.99, 1};

// Another mapping with nested panels judges every tolerance. Caught when tried: a node law 20 %
// smaller, a horizon 1e-3 lower, alpha² 1e-4 larger.
TEST(SplitSumQuadrature, MeetsEveryTolerance) {
    struct Pair {
        SmithTerm term;
        double alpha, n_dot_v;
    };
    std::vector<Pair> pairs;
    for (const SmithTermInfo& info : smith_terms())
        for (const double alpha : alphas)
            for (const double n_dot_v : cosines) pairs.push_back({info.term, alpha, n_dot_v});
    parallel_rows(static_cast<int>(pairs.size()), [&](int i) {
        const auto [term, alpha, n_dot_v] = pairs[static_cast<size_t>(i)];
        const SplitSum exact = split_sum_exact(term, n_dot_v, alpha);
        for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8}) {
            const SplitSum sum = split_sum_by_quadrature(term, n_dot_v, alpha, tolerance);
            EXPECT_NEAR(sum.a, exact.a, tolerance) << alpha << " " << n_dot_v;
            EXPECT_NEAR(sum.b, exact.b, tolerance) << alpha << " " << n_dot_v;
        }
    });
}

// Interpolated tables meet the accuracy of their plan as well as the texels that are integrated.
TEST(SplitSumQuadrature, InterpolationKeepsTheAccuracy) {
    NoProgress progress;
    for (const double accuracy : {1e-2, 1e-4, 1e-6})
        for (const int size : {31, 300, 1500})
            for (const auto layout : {TexelLayout::centre, TexelLayout::edge}) {
                TablePlan plan;
                plan.accuracy = accuracy;
                plan.size = size;
                plan.layout = layout;
                const TableGrid grid = grid_of(plan, ViewAxis::cosine);
                const auto sums = split_sums_by_quadrature(plan, grid, progress);
                for (int i = 0; i < 60; ++i) {
                    const int x = (i % 3 == 0 ? i / 3 : 7919 * i) % size;
                    const int y = (i % 2 == 0 ? i / 4 : 104729 * i) % size;
                    const double r = grid.perceptual_roughness[size_t(y)];
                    const SplitSum exact =
                        split_sum_exact(plan.geometry, grid.n_dot_v[size_t(x)], r * r);
                    const SplitSum found = sums[size_t(y) * size_t(size) + size_t(x)];
                    EXPECT_NEAR(found.a, exact.a, accuracy) << size << " " << x << " " << y;
                    EXPECT_NEAR(found.b, exact.b, accuracy) << size << " " << x << " " << y;
                }
            }
}

// The horizon that the rules end at is where n·l is 0.
TEST(HalfVectorRules, EndWhereTheLightSinksBelowTheHorizon) {
    const GaussRules gauss;
    for (const double n_dot_v : {1e-6, 0.01, 0.4, 0.9, 1.0})
        for (const Azimuth& at : azimuth_rule(gauss, n_dot_v, 1e-6).azimuths) {
            const double theta = 2 * std::atan(at.horizon);
            const double n_dot_l = at.across * std::sin(2 * theta) + n_dot_v * std::cos(2 * theta);
            EXPECT_NEAR(n_dot_l, 0, 1e-14) << n_dot_v << " " << at.across;
            EXPECT_GT(n_dot_v * std::cos(theta) + at.across * std::sin(theta), 0);
        }
}

TEST(HalfVectorRules, AzimuthsAreTheWholeCircle) {
    const GaussRules gauss;
    for (const double n_dot_v : {0.0, 1e-6, 0.01, 0.4, 1.0}) {
        double circle = 0;
        for (const Azimuth& at : azimuth_rule(gauss, n_dot_v, 1e-8).azimuths) circle += at.weight;
        EXPECT_NEAR(circle, 2 * std::numbers::pi, 1e-6) << n_dot_v;
    }
}

TEST(HalfVectorRules, PolarNodesCoverTheUnitIntervalAndArePadded) {
    const GaussRules gauss;
    for (const double alpha : {1e-6, 0.01, 1.0})
        for (const double n_dot_v : {0.0, 1e-3, 1.0}) {
            const PolarRule rule = polar_rule(gauss, alpha, n_dot_v, 1e-8);
            EXPECT_EQ(rule.nodes.size() % polar_padding, 0u);
            double length = 0, moment = 0;
            for (size_t i = 0; i < rule.nodes.size(); ++i) {
                length += rule.weights[i];
                moment += rule.weights[i] * rule.nodes[i];
            }
            EXPECT_NEAR(length, 1, 1e-7) << alpha << " " << n_dot_v;
            EXPECT_NEAR(moment, 0.5, 1e-7) << alpha << " " << n_dot_v;
        }
}

}  // namespace
}  // namespace splitsum
