#include "splitsum/brdf/lobe.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/math/quadrature.h"

namespace splitsum {

double lobe_integral(const Lobe& lobe) {
    if (lobe.kind == LobeKind::cosine) return std::numbers::pi;
    const QuadratureRule rule = gauss_legendre(16);
    const double horizon = 0.5 * std::numbers::pi;
    double sum = 0;
    for (double from = 0; from < horizon;) {
        const double to = std::min(horizon, from + 0.5 * std::max(from, lobe_width(lobe)));
        sum += integrate(rule, from, to, [&](double theta) {
            const double half = std::sin(0.5 * theta);
            return lobe_value(lobe, 2 * half * half) * std::sin(theta);
        });
        from = to;
    }
    return 2 * std::numbers::pi * sum;
}

}  // namespace splitsum
