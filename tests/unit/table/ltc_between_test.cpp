#include "splitsum/table/ltc_between.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace splitsum {
namespace {

// The exact matrix of a narrow lobe (tests/unit/ltc/fit_test.cpp).
LtcInverse narrow_lobe(double n_dot_v, double alpha) {
    const double s = std::sqrt((1 - n_dot_v) * (1 + n_dot_v)), width = 2 * alpha * n_dot_v;
    return {
        .m00 = n_dot_v * n_dot_v, .m20 = -width * s, .m02 = n_dot_v * s, .m22 = width * n_dot_v};
}

TableGrid grid_of_size(int size, double perceptual_roughness) {
    TablePlan plan;
    plan.size = size;
    plan.layout = TexelLayout::edge;
    TableGrid grid = grid_of(plan, ViewAxis::sqrt_one_minus_cosine);
    grid.perceptual_roughness = {perceptual_roughness};
    return grid;
}

std::vector<LtcInverse> exact(const TableGrid& grid) {
    std::vector<LtcInverse> matrices;
    const double r = grid.perceptual_roughness.front();
    for (const double n_dot_v : grid.n_dot_v)
        matrices.push_back(narrow_lobe(std::max(n_dot_v, 0.002), r * r));
    return matrices;
}

// How far, in radians, the peak of what a linear filter reads lies from the mirror direction: the root
// mean square over views on no grid, with sqrt(1 - n·v) from `from` to `to`.
double misdirection(const std::vector<LtcInverse>& matrices, double from, double to) {
    constexpr int count = 997;
    double sum = 0;
    for (int i = 0; i < count; ++i) {
        const double t = from + (to - from) * (i + 0.5) / count, c = 1 - t * t;
        const double at = t * static_cast<double>(matrices.size() - 1);
        const auto low = static_cast<size_t>(at);
        const double part = at - std::floor(at);
        const auto mix = [&](double a, double b) { return a + part * (b - a); };
        const double m00 = mix(matrices[low].m00, matrices[low + 1].m00);
        const double m02 = mix(matrices[low].m02, matrices[low + 1].m02);
        const double off = std::atan2(m00, m02) - std::asin(c);
        sum += off * off;
    }
    return std::sqrt(sum / count);
}

TEST(FitBetweenViews, NarrowLobesPointWhereMirrorsDo) {
    const TableGrid grid = grid_of_size(64, 0.04);
    const std::vector<LtcInverse> before = exact(grid);
    std::vector<LtcInverse> after = before;
    fit_between_views(after, grid);
    // Of a parabola it would be sqrt(6).
    EXPECT_LT(misdirection(after, 0.1, 0.95), 0.5 * misdirection(before, 0.1, 0.95));
    // The interval that ends edge on.
    EXPECT_LT(misdirection(after, 62.0 / 63, 1), 0.05 * misdirection(before, 62.0 / 63, 1));
    for (const LtcInverse& m : after) EXPECT_GT(determinant(m), 0);
}

// Measured: 6.6e-4 before, below 1e-6 after; the lobe is 1e-4 wide.
TEST(FitBetweenViews, MirrorsPointWhereMirrorsDoAtEveryView) {
    const TableGrid grid = grid_of_size(64, 0.01);
    const std::vector<LtcInverse> before = exact(grid);
    std::vector<LtcInverse> after = before;
    fit_between_views(after, grid);
    RecordProperty("before", std::to_string(misdirection(before, 0.03, 62.0 / 63)));
    RecordProperty("after", std::to_string(misdirection(after, 0.03, 62.0 / 63)));
    EXPECT_LT(misdirection(after, 0.03, 62.0 / 63), 1e-5);
    EXPECT_LT(misdirection(after, 62.0 / 63, 1), 1e-4);
    for (size_t i = 0; i < after.size(); ++i) {
        EXPECT_GT(determinant(after[i]), 0);
        // At texels nothing turns, and the plane that cuts the lobe off stays.
        if (i + 1 < after.size()) {
            EXPECT_NEAR(std::atan2(after[i].m00, after[i].m02),
                        std::atan2(before[i].m00, before[i].m02), 1e-12);
        }
        EXPECT_EQ(after[i].m20, before[i].m20);
        EXPECT_EQ(after[i].m22, before[i].m22);
    }
}

// Between the points of a parabola y the line through y - y'' / 12 is the nearest; lines stay.
TEST(FitBetweenViews, ParabolasMoveByATwelfthOfTheirSecondDifference) {
    const TableGrid grid = grid_of_size(64, 0.5);
    std::vector<LtcInverse> before(64);
    for (size_t i = 0; i < 64; ++i) {
        const double t = static_cast<double>(i);
        before[i] = {.m00 = 1 + 1e-3 * t * t, .m20 = 0.1, .m02 = 0.01 * t, .m22 = 1};
    }
    std::vector<LtcInverse> after = before;
    fit_between_views(after, grid);
    for (size_t i = 1; i + 2 < after.size(); ++i) {
        EXPECT_NEAR(before[i].m00 - after[i].m00, 2e-3 / 12, 1e-12);
        EXPECT_NEAR(after[i].m02, before[i].m02, 1e-12);
        EXPECT_NEAR(after[i].m20, before[i].m20, 1e-12);
    }
    EXPECT_EQ(after.back().m00, before.back().m00);
}

TEST(FitBetweenViews, TakesGridsOfAnySize) {
    for (const int size : {2, 3}) {
        const TableGrid grid = grid_of_size(size, 0.01);
        std::vector<LtcInverse> matrices = exact(grid);
        fit_between_views(matrices, grid);
        for (const LtcInverse& m : matrices) EXPECT_GT(determinant(m), 0) << size;
    }
}

// A dip that lies between the last two texels, as the albedo of narrow lobes has: the line through its
// ends misses it, and no line from the same neighbour comes nearer than the one that is found.
TEST(ValueEdgeOn, IsTheLineNearestToADip) {
    const LastInterval interval = last_interval(grid_of_size(64, 0.05));
    ASSERT_FALSE(interval.n_dot_v.empty());
    std::vector<double> exact;
    for (const double c : interval.n_dot_v) exact.push_back(1 - 0.1 * c * (0.04 - c) / 0.0004);
    const auto missed_by = [&](double at_edge) {
        double sum = 0;
        for (size_t i = 0; i < exact.size(); ++i) {
            const double share = interval.at_edge[i];
            const double off = share * at_edge + (1 - share) * 0.98 - exact[i];
            sum += interval.weights[i] * off * off;
        }
        return sum;
    };
    const double found = value_edge_on(interval, 0.98, exact);
    EXPECT_LT(missed_by(found), 0.5 * missed_by(1));
    EXPECT_LT(missed_by(found), missed_by(found - 0.01));
    EXPECT_LT(missed_by(found), missed_by(found + 0.01));
}

TEST(ValueEdgeOn, IsTheValueItselfOfALine) {
    const LastInterval interval = last_interval(grid_of_size(64, 0.05));
    std::vector<double> exact;
    for (const double share : interval.at_edge) exact.push_back(0.7 + 0.2 * share);
    EXPECT_NEAR(value_edge_on(interval, 0.7, exact), 0.9, 1e-12);
}

TEST(LastInterval, IsEmptyWithoutATexelEdgeOn) {
    TablePlan plan;
    plan.size = 64;
    plan.layout = TexelLayout::centre;
    EXPECT_TRUE(last_interval(grid_of(plan, ViewAxis::sqrt_one_minus_cosine)).n_dot_v.empty());
}

}  // namespace
}  // namespace splitsum
