#include "splitsum/math/quadrature.h"

#include <cmath>
#include <numbers>

namespace splitsum {
namespace {

struct LegendreValue {
    double value;
    double derivative;
};

// P_n and its derivative at x by the three-term recurrence.
LegendreValue legendre(int n, double x) {
    double previous = 1;
    double current = x;
    for (int k = 2; k <= n; ++k) {
        const double next = ((2 * k - 1) * x * current - (k - 1) * previous) / k;
        previous = current;
        current = next;
    }
    return {current, n * (x * current - previous) / (x * x - 1)};
}

}  // namespace

QuadratureRule gauss_legendre(int count) {
    QuadratureRule rule{std::vector<double>(count), std::vector<double>(count)};
    if (count == 1) return {{0.0}, {2.0}};
    for (int i = 0; i < (count + 1) / 2; ++i) {
        double x = std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5));
        LegendreValue p = legendre(count, x);
        for (int step = 0; step < 100; ++step) {
            const double change = p.value / p.derivative;
            x -= change;
            p = legendre(count, x);
            if (std::abs(change) < 1e-15) break;
        }
        if (2 * i + 1 == count) x = 0;
        const double weight = 2 / ((1 - x * x) * p.derivative * p.derivative);
        rule.nodes[i] = -x;
        rule.nodes[count - 1 - i] = x;
        rule.weights[i] = rule.weights[count - 1 - i] = weight;
    }
    return rule;
}

}  // namespace splitsum
