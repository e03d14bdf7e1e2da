#include "splitsum/table/half_vector_rules.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace splitsum {
namespace {

constexpr double quarter_turn = 0.5 * std::numbers::pi;
// Gauss rules are made for multiples of it only.
constexpr int node_step = 4;
constexpr int most_nodes = 96;

// How many Gauss points an interval of mapped length `length` needs for an error `tolerance`:
// ln(1 / tolerance) (base + slope length), as theory says of its shape; base and slope measured with
// all three geometry terms for tolerances 5e-8 and 1e-4, alpha 1e-6 .. 1, n·v 1e-4 .. 1, rounded up.
struct NodeLaw {
    double base;
    double slope;
};
constexpr NodeLaw lobe_law{0.28, 0.155};
constexpr NodeLaw horizon_law{0.25, 0.1};
constexpr NodeLaw azimuth_law{0.3, 0.105};

double nodes_for(const NodeLaw& law, double length, double tolerance) {
    return std::log(1 / tolerance) * (law.base + law.slope * length);
}

// d = e sinh(u T) over [0, length], u in [0, 1].
struct SinhMap {
    double first;   // e
    double length;  // L
    double mapped;  // T

    SinhMap(double e, double l) : first(e), length(l), mapped(std::asinh(l / e)) {}
};

// Calls add(distance, weight) for every node of a Gauss rule on the map, nearest first.
template <class Add>
void for_each_node(const SinhMap& map, const QuadratureRule& rule, const Add& add) {
    for (size_t i = 0; i < rule.nodes.size(); ++i) {
        const double t = 0.5 * (1 + rule.nodes[i]) * map.mapped;
        add(map.first * std::sinh(t),
            0.5 * rule.weights[i] * map.mapped * map.first * std::cosh(t));
    }
}

// tan(theta_max / 2) from cos(2 theta_max) = -across / R, without a difference of equals.
double horizon_at(double across, double n_dot_v) {
    const double amplitude = std::hypot(across, n_dot_v);
    if (amplitude == 0) return 0;
    const double large = 1 + std::abs(across) / amplitude;  // 2 sin² or 2 cos², the larger
    const double small = n_dot_v * n_dot_v / (amplitude * amplitude * large);
    const double sin2 = 0.5 * (across > 0 ? large : small);
    const double cos2 = 0.5 * (across > 0 ? small : large);
    return std::sqrt(sin2) / (1 + std::sqrt(cos2));
}

// How near to the horizon the shadowing has a singularity. It weighs with n·v where that is small,
// so very grazing views, and n·v = 0 where it is gone, need no finer rule than these.
double horizon_scale(double alpha, double n_dot_v) {
    constexpr double most_grazing = 1e-5;
    return 0.25 * (n_dot_v > 0 ? std::min(alpha, std::max(n_dot_v, most_grazing)) : alpha);
}

}  // namespace

GaussRules::GaussRules() {
    for (int count = node_step; count <= most_nodes; count += node_step)
        rules_.push_back(gauss_legendre(count));
}

const QuadratureRule& GaussRules::with(double nodes) const {
    const auto step = static_cast<size_t>(std::max(1.0, std::ceil(nodes / node_step)));
    return rules_[std::min(step, rules_.size()) - 1];
}

int polar_octave(double alpha, double n_dot_v) { return std::ilogb(horizon_scale(alpha, n_dot_v)); }

PolarRule polar_rule(const GaussRules& gauss, double alpha, double n_dot_v, double tolerance) {
    const SinhMap lobe(0.5 * alpha, 0.5);
    const SinhMap horizon(std::ldexp(1.0, polar_octave(alpha, n_dot_v)), 0.5);
    PolarRule rule;
    for_each_node(lobe, gauss.with(nodes_for(lobe_law, lobe.mapped, tolerance)),
                  [&](double d, double weight) {
                      rule.nodes.push_back(d);
                      rule.weights.push_back(weight);
                  });
    for_each_node(horizon, gauss.with(nodes_for(horizon_law, horizon.mapped, tolerance)),
                  [&](double d, double weight) {
                      rule.nodes.push_back(1 - d);
                      rule.weights.push_back(weight);
                  });
    while (rule.nodes.size() % polar_padding != 0) {
        rule.nodes.push_back(0.5);
        rule.weights.push_back(0);
    }
    return rule;
}

AzimuthRule azimuth_rule(const GaussRules& gauss, double n_dot_v, double tolerance) {
    constexpr double most_grazing = 1e-5;
    const double sin_v = std::sqrt((1 - n_dot_v) * (1 + n_dot_v));
    const SinhMap from_quarter(std::max(n_dot_v, most_grazing), quarter_turn);
    const QuadratureRule& nodes =
        gauss.with(nodes_for(azimuth_law, from_quarter.mapped, tolerance));
    AzimuthRule rule;
    rule.n_dot_v = n_dot_v;
    for (const double side : {1.0, -1.0})
        for_each_node(from_quarter, nodes, [&](double d, double weight) {
            const double across = side * sin_v * std::sin(d);  // cos(pi / 2 - d)
            rule.azimuths.push_back({across, horizon_at(across, n_dot_v), 2 * weight});
        });
    return rule;
}

}  // namespace splitsum
