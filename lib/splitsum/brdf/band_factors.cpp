#include "splitsum/brdf/band_factors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "splitsum/math/quadrature.h"

namespace splitsum {
namespace {

constexpr size_t nodes_per_panel = 16;
using PanelValues = std::array<double, nodes_per_panel>;

// One panel's nodes: the versine 1 - cos(theta) of each, and weight * K * sin(theta).
struct Panel {
    PanelValues versine;
    PanelValues weight;
};

Panel panel_between(const Lobe& lobe, const QuadratureRule& rule, double from, double to) {
    Panel panel;
    const double half = 0.5 * (to - from);
    for (size_t i = 0; i < nodes_per_panel; ++i) {
        const double theta = from + half * (1 + rule.nodes[i]);
        const double sin_half = std::sin(0.5 * theta);
        panel.versine[i] = 2 * sin_half * sin_half;
        panel.weight[i] =
            half * rule.weights[i] * lobe_value(lobe, panel.versine[i]) * std::sin(theta);
    }
    return panel;
}

// Adds the panel's share of ∫ K P_l to sums[l].
//
// The recurrence runs in differences d_l = P_l - P_(l-1),
//     (l + 1) d_(l+1) = l d_l - (2 l + 1) (1 - c) P_l,
// because near c = 1, where narrow lobes live, rounding c itself costs P_l about l² / 2 ulp.
void add_panel(const Panel& panel, std::vector<double>& sums) {
    PanelValues value;
    PanelValues difference{};
    value.fill(1);
    for (size_t l = 0; l < sums.size(); ++l) {
        double sum = 0;
        for (size_t i = 0; i < nodes_per_panel; ++i) sum += panel.weight[i] * value[i];
        sums[l] += sum;
        const double order = static_cast<double>(l);
        const double keep = order / (order + 1);
        const double turn = (2 * order + 1) / (order + 1);
        for (size_t i = 0; i < nodes_per_panel; ++i) {
            difference[i] = keep * difference[i] - turn * panel.versine[i] * value[i];
            value[i] += difference[i];
        }
    }
}

// Panels grow with the distance from the peak, where the lobe's poles recede, and stay short enough
// for the fastest harmonic: 12 radians of it across a panel leave a 16-point rule below 1e-15.
double panel_end(double from, double lobe_width, int count) {
    const double smooth = 0.5 * std::max(lobe_width, from);
    const double resolved = 12.0 / count;
    return std::min(from + std::min(smooth, resolved), 0.5 * std::numbers::pi);
}

}  // namespace

std::vector<double> band_factors(const Lobe& lobe, int count) {
    // Below this width alpha² underflows, and every factor has long rounded to 1.
    if (lobe.kind == LobeKind::ggx && lobe.alpha < 1e-30)
        return std::vector<double>(static_cast<size_t>(count), 1.0);

    const QuadratureRule rule = gauss_legendre(nodes_per_panel);
    std::vector<double> factors(static_cast<size_t>(count), 0.0);
    for (double from = 0; from < 0.5 * std::numbers::pi;) {
        const double to = panel_end(from, lobe_width(lobe), count);
        add_panel(panel_between(lobe, rule, from, to), factors);
        from = to;
    }
    const double total = factors.front();
    for (double& factor : factors) factor /= total;
    return factors;
}

}  // namespace splitsum
