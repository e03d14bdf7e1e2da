#include "splitsum/ltc/lobe_difference.h"

#include <cmath>
#include <limits>

#include "splitsum/brdf/lambert.h"
#include "splitsum/math/harmonics.h"
#include "splitsum/math/quadrature.h"

namespace splitsum {
namespace {

constexpr double share_of_cosine_space = 0.5;
constexpr double share_of_chi2 = 3e-4;
constexpr double share_of_tilt = 1e-4;
constexpr double largest_tilt = 1.5;  // beyond pi / 2 the lobe is turned inside out

// Directions that follow a transformed cosine, over the half y >= 0, and their weights in u.
template <class Visit>
void visit_cosine_nodes(int count, const Visit& visit) {
    const QuadratureRule rule = gauss_legendre(count);
    for (size_t i = 0; i < rule.nodes.size(); ++i)
        for (size_t j = 0; j < rule.nodes.size(); ++j)
            visit(sample_cosine_direction({0.5 * (1 + rule.nodes[i]), 0.25 * (1 + rule.nodes[j])}),
                  0.125 * rule.weights[i] * rule.weights[j]);
}

// Harmonics that are even in y, the others are blind to lobes that are.
std::vector<size_t> even_harmonics(int order) {
    std::vector<size_t> indices;
    for (int l = 0; l <= order; ++l)
        for (int m = 0; m <= l; ++m) indices.push_back(harmonic_index(l, m));
    return indices;
}

double dot_product(const double* a, const double* b, size_t count) {
    double sums[4] = {0, 0, 0, 0};
    size_t i = 0;
    for (; i + 4 <= count; i += 4)
        for (size_t lane = 0; lane < 4; ++lane) sums[lane] += a[i + lane] * b[i + lane];
    for (; i < count; ++i) sums[0] += a[i] * b[i];
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

}  // namespace

LobeDifference::LobeDifference(const TargetLobe& target, const LtcShape& around,
                               const LtcFitPlan& plan) {
    const LtcInverse inverse = inverse_of(around);
    for (const LobeNode& node : target.nodes(plan.nodes)) {
        const double pdf = target.sampling_pdf(node.light);
        add_direction(target, inverse, node.light, node.weight * pdf);
    }
    visit_cosine_nodes(plan.nodes, [&](const Vec3d& node, double weight) {
        add_direction(target, inverse, normalize(from_cosine_space(inverse, node)), weight);
    });
    make_harmonics(inverse, plan.order);
}

void LobeDifference::add_direction(const TargetLobe& target, const LtcInverse& around,
                                   const Vec3d& direction, double weight) {
    const double density = target.density(direction);
    const double lobe = ltc_density(around, direction);
    const double pdf = target.sampling_pdf(direction) + lobe;
    if (!(pdf > 0)) return;
    directions_.push_back(direction);
    densities_.push_back(density);
    weights_.push_back(2 * weight / pdf);  // the half y < 0 as well
    chi_weights_.push_back(share_of_chi2 * weights_.back() * 2 / (density + lobe));
}

void LobeDifference::make_harmonics(const LtcInverse& around, int order) {
    const std::vector<size_t> indices = even_harmonics(order);
    const size_t count = directions_.size();
    harmonics_.resize(2 * indices.size() * count);
    std::vector<double> values(harmonic_count(order));
    for (size_t i = 0; i < count; ++i)
        for (const bool in_cosine_space : {false, true}) {
            const Vec3d direction = in_cosine_space
                                        ? normalize(to_cosine_space(around, directions_[i]))
                                        : directions_[i];
            evaluate_harmonics(direction, order, values);
            const size_t first_row = in_cosine_space ? indices.size() : 0;
            const double weight = weights_[i] * (in_cosine_space ? share_of_cosine_space : 1);
            for (size_t row = 0; row < indices.size(); ++row) {
                const double band = std::floor(std::sqrt(static_cast<double>(indices[row])));
                harmonics_[(first_row + row) * count + i] =
                    weight / (band + 0.5) * values[indices[row]];
            }
        }
}

void LobeDifference::project(const std::vector<double>& values,
                             std::vector<double>& projections) const {
    const size_t count = directions_.size();
    projections.resize(harmonics_.size() / count);
    for (size_t row = 0; row < projections.size(); ++row)
        projections[row] = dot_product(&harmonics_[row * count], values.data(), count);
}

double LobeDifference::value(const LtcShape& shape) const {
    const LtcInverse inverse = inverse_of(shape);
    const size_t count = directions_.size();
    std::vector<double> e(count);
    if (std::abs(shape.tilt) > largest_tilt) return std::numeric_limits<double>::infinity();
    double sum = share_of_tilt * shape.tilt * shape.tilt;
    for (size_t i = 0; i < count; ++i) {
        e[i] = ltc_density(inverse, directions_[i]) - densities_[i];
        sum += chi_weights_[i] * e[i] * e[i];
    }
    std::vector<double> projections;
    project(e, projections);
    return sum + dot_product(projections.data(), projections.data(), projections.size());
}

LobeDifference::Model LobeDifference::model(const LtcShape& shape) const {
    constexpr size_t n = Model::n;
    const size_t count = directions_.size();
    // The difference and its derivatives by the n parameters, at every direction.
    std::array<std::vector<double>, n + 1> columns;
    for (std::vector<double>& column : columns) column.resize(count);
    const LtcDifferentiator differentiate(shape);
    for (size_t i = 0; i < count; ++i) {
        const LtcSlope slope = differentiate(directions_[i]);
        for (size_t a = 0; a < n; ++a) columns[a][i] = slope.by_parameter[a];
        columns[n][i] = slope.density - densities_[i];
    }
    std::array<std::vector<double>, n + 1> projections;
    for (size_t a = 0; a <= n; ++a) project(columns[a], projections[a]);
    std::vector<double> weighted(count);
    std::array<std::array<double, n + 1>, n + 1> products{};
    for (size_t a = 0; a <= n; ++a) {
        for (size_t i = 0; i < count; ++i) weighted[i] = chi_weights_[i] * columns[a][i];
        for (size_t b = a; b <= n; ++b)
            products[a][b] = products[b][a] =
                dot_product(weighted.data(), columns[b].data(), count) +
                dot_product(projections[a].data(), projections[b].data(), projections[a].size());
    }
    products[0][0] += share_of_tilt;
    products[0][n] += share_of_tilt * shape.tilt;
    products[n][n] += share_of_tilt * shape.tilt * shape.tilt;
    Model model;
    model.value = products[n][n];
    for (size_t a = 0; a < n; ++a) {
        model.gradient[a] = products[a][n];
        for (size_t b = 0; b < n; ++b) model.hessian[a][b] = products[a][b];
    }
    return model;
}

}  // namespace splitsum
