#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "splitsum/math/quadrature.h"

namespace splitsum {

/// Visits nodes of the integral over what lies between `from` and `to` (either side), on panels that
/// start at `growth` times `first` and grow with the distance from `from`: whatever happens on that
/// length there is resolved. The integral is the sum of weight f(at) over visit(at, weight).
template <class Visit>
void visit_graded(const QuadratureRule& rule, double from, double to, double first, double growth,
                  const Visit& visit) {
    const double length = std::abs(to - from);
    const double sign = to < from ? -1 : 1;
    for (double near = 0; near < length;) {
        const double far = std::min(length, near + growth * std::max(first, near));
        for (std::size_t i = 0; i < rule.nodes.size(); ++i)
            visit(from + sign * (near + 0.5 * (far - near) * (1 + rule.nodes[i])),
                  0.5 * (far - near) * rule.weights[i]);
        near = far;
    }
}

/// The same integral of numbers.
template <class Function>
double integrate_graded(const QuadratureRule& rule, double from, double to, double first,
                        double growth, const Function& f) {
    double sum = 0;
    visit_graded(rule, from, to, first, growth,
                 [&](double at, double weight) { sum += weight * f(at); });
    return sum;
}

}  // namespace splitsum
