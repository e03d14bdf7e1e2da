#pragma once

#include <span>
#include <vector>

namespace splitsum {

/// The x >= 0 that minimises x·A x / 2 - b·x, for a symmetric positive definite A (row-major,
/// b.size() squared entries): least squares with non-negative unknowns by their normal equations.
///
/// Active sets (Lawson & Hanson 1974, "Solving Least Squares Problems", ch. 23): unknowns enter the
/// set of free ones where the gradient says so and leave it at 0. A diagonal share of 1e-10 keeps
/// nearly dependent columns apart. At the end the free unknowns have no gradient and the others
/// none that would lower the sum (tested to 1e-8 of the largest b). Cost: about n steps of n³ / 6.
std::vector<double> non_negative_least_squares(std::span<const double> matrix,
                                               std::span<const double> rhs);

}  // namespace splitsum
