#pragma once

#include <cstddef>
#include <vector>

namespace splitsum {

/// Nodes in (-1, 1), ascending, and weights that sum to 2.
struct QuadratureRule {
    std::vector<double> nodes;
    std::vector<double> weights;
};

/// The Gauss-Legendre rule with `count` nodes, exact for polynomials of degree 2 count - 1.
/// Newton's method on the Legendre recurrence from Tricomi's first guess; nodes to 1 ulp-scale
/// accuracy (tested: weights sum to 2 within 1e-14 up to count = 512). Cost: O(count²).
QuadratureRule gauss_legendre(int count);

/// The integral of f over [from, to] by `rule`.
template <class Function>
double integrate(const QuadratureRule& rule, double from, double to, const Function& f) {
    const double half = 0.5 * (to - from);
    const double middle = 0.5 * (to + from);
    double sum = 0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i)
        sum += rule.weights[i] * f(middle + half * rule.nodes[i]);
    return half * sum;
}

}  // namespace splitsum
