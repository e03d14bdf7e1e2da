#include "splitsum/math/tanh_sinh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace splitsum {
namespace {

template <class Function>
double integral(double step, const Function& f) {
    double sum = 0;
    for (const UnitNode& node : tanh_sinh(step)) sum += node.weight * f(node);
    return sum;
}

TEST(TanhSinh, WeightsSumToOneAndNodesAreSymmetric) {
    for (const double step : {1.0 / 8, 1.0 / 16, 1.0 / 40})
        EXPECT_NEAR(integral(step, [](const UnitNode&) { return 1; }), 1, 1e-11) << step;
    const auto nodes = tanh_sinh(0.125);
    EXPECT_EQ(nodes.size(), 51u);
    for (size_t i = 0; i < nodes.size(); ++i) {
        EXPECT_DOUBLE_EQ(nodes[i].from_start, nodes[nodes.size() - 1 - i].from_end);
        EXPECT_NEAR(nodes[i].from_start + nodes[i].from_end, 1, 1e-15);
    }
}

TEST(TanhSinh, TakesRootsAndLogarithmsAtBothEnds) {
    EXPECT_NEAR(integral(1.0 / 16, [](const UnitNode& n) { return std::log(n.from_start); }), -1,
                1e-11);
    EXPECT_NEAR(
        integral(1.0 / 16, [](const UnitNode& n) { return std::sqrt(n.from_start * n.from_end); }),
        std::numbers::pi / 8, 1e-11);
}

// A layer of 1e-5 at the far end: ∫ w / (1 - x + w) dx = w log(1 + 1 / w).
TEST(TanhSinh, ResolvesLayers) {
    const double w = 1e-5;
    EXPECT_NEAR(integral(1.0 / 20, [&](const UnitNode& n) { return w / (n.from_end + w); }) /
                    (w * std::log1p(1 / w)),
                1, 1e-8);
}

}  // namespace
}  // namespace splitsum
