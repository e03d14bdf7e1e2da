#include "splitsum/filter/gaussians_least_squares.h"

#include <gtest/gtest.h>

#include <cmath>

#include "splitsum/base/random.h"

namespace splitsum {
namespace {

struct Problem {
    std::vector<double> matrix;
    std::vector<double> rhs;
};

// Normal equations of `rows` random equations: dependent columns where there are too few of them.
Problem random_problem(size_t unknowns, size_t rows, uint32_t seed) {
    std::vector<double> a(rows * unknowns), wanted(rows);
    uint32_t key = mix_bits(seed);
    for (double& value : a) value = double(unit_float(key++)) - 0.3;
    for (double& value : wanted) value = double(unit_float(key++)) - 0.5;
    Problem problem{std::vector<double>(unknowns * unknowns), std::vector<double>(unknowns)};
    for (size_t r = 0; r < rows; ++r)
        for (size_t i = 0; i < unknowns; ++i) {
            problem.rhs[i] += a[r * unknowns + i] * wanted[r];
            for (size_t j = 0; j < unknowns; ++j)
                problem.matrix[i * unknowns + j] += a[r * unknowns + i] * a[r * unknowns + j];
        }
    return problem;
}

// The conditions of Karush, Kuhn and Tucker, which only the minimum meets: no unknown below 0, no
// descent left at 0, and none either way above it.
TEST(NonNegativeLeastSquares, FindsTheOnlyMinimum) {
    for (uint32_t seed = 0; seed < 40; ++seed) {
        const size_t n = 1 + seed % 24;
        const Problem problem = random_problem(n, n + 8, seed);
        const auto x = non_negative_least_squares(problem.matrix, problem.rhs);
        double largest = 0;
        for (const double b : problem.rhs) largest = std::max(largest, std::abs(b));
        for (size_t i = 0; i < n; ++i) {
            double descent = problem.rhs[i];
            for (size_t j = 0; j < n; ++j) descent -= problem.matrix[i * n + j] * x[j];
            ASSERT_GE(x[i], 0) << "seed " << seed;
            ASSERT_LT(descent, 1e-8 * largest) << "seed " << seed << ", unknown " << i;
            if (x[i] > 0) {
                ASSERT_GT(descent, -1e-8 * largest) << "seed " << seed;
            }
        }
    }
}

TEST(NonNegativeLeastSquares, LeavesAPositiveSolutionAlone) {
    const std::vector<double> matrix = {4, 1, 0, 1, 3, 1, 0, 1, 2};
    const auto x = non_negative_least_squares(matrix, std::vector<double>{5.0, 9.25, 7.0});
    EXPECT_NEAR(x[0], 0.75, 1e-8);
    EXPECT_NEAR(x[1], 2.0, 1e-8);
    EXPECT_NEAR(x[2], 2.5, 1e-8);
}

TEST(NonNegativeLeastSquares, TakesDependentColumnsAndNothing) {
    const Problem problem = random_problem(20, 6, 3);
    for (const double x : non_negative_least_squares(problem.matrix, problem.rhs)) {
        EXPECT_TRUE(std::isfinite(x) && x >= 0) << x;
    }
    const std::vector<double> nothing(20, 0.0);
    EXPECT_EQ(non_negative_least_squares(problem.matrix, nothing), nothing);
}

}  // namespace
}  // namespace splitsum
