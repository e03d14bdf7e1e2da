#include "splitsum/brdf/lobe.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/math/quadrature.h"

namespace splitsum {

double lobe_integral_within(const Lobe& lobe, double radius) {
    const QuadratureRule rule = gauss_legendre(16);
    double sum = 0;
    for (double from = 0; from < radius;) {
        const double to = std::min(radius, from + 0.5 * std::max(from, lobe_width(lobe)));
        sum += integrate(rule, from, to, [&](double theta) {
            const double half = std::sin(0.5 * theta);
            return lobe_value(lobe, 2 * half * half) * std::sin(theta);
        });
        from = to;
    }
    return 2 * std::numbers::pi * sum;
}

double lobe_integral(const Lobe& lobe) {
    return lobe_integral_within(lobe, 0.5 * std::numbers::pi);
}

}  // namespace splitsum
