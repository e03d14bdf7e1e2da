#include "splitsum/math/quadrature.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace splitsum {
namespace {

TEST(GaussLegendre, WeightsSumToTwo) {
    for (const int count : {1, 2, 3, 7, 16, 63, 128, 511, 512}) {
        const QuadratureRule rule = gauss_legendre(count);
        const double sum = std::accumulate(rule.weights.begin(), rule.weights.end(), 0.0);
        EXPECT_NEAR(sum, 2, 1e-14) << count << " nodes";
    }
}

TEST(GaussLegendre, NodesAscendInsideTheInterval) {
    for (const int count : {1, 2, 3, 7, 16, 63, 512}) {
        double previous = -1;
        for (const double x : gauss_legendre(count).nodes) {
            EXPECT_LT(previous, x);
            previous = x;
        }
        EXPECT_LT(previous, 1);
    }
}

// The defining property, and its end: degree 2 n - 1 is exact, degree 2 n is not.
TEST(GaussLegendre, IsExactUpToItsDegree) {
    for (const int count : {1, 2, 3, 5, 8}) {
        const QuadratureRule rule = gauss_legendre(count);
        const auto integral = [&](int degree) {
            return integrate(rule, 0, 1, [=](double x) { return std::pow(x, degree); });
        };
        for (int degree = 0; degree < 2 * count; ++degree)
            EXPECT_NEAR(integral(degree), 1.0 / (degree + 1), 1e-14) << count << ", " << degree;
        EXPECT_GT(std::abs(integral(2 * count) - 1.0 / (2 * count + 1)), 1e-12) << count;
    }
}

TEST(GaussLegendre, IntegratesOverAnyInterval) {
    const QuadratureRule rule = gauss_legendre(12);
    const double integral = integrate(rule, -1.5, 2.25, [](double x) { return std::exp(x); });
    EXPECT_NEAR(integral, std::exp(2.25) - std::exp(-1.5), 1e-12);
}

}  // namespace
}  // namespace splitsum
