#include "splitsum/ltc/lobe_difference.h"

#include <cmath>
#include <limits>

#include "splitsum/brdf/lambert.h"
#include "splitsum/math/quadrature.h"

namespace splitsum {
namespace {

constexpr double share_of_chi2 = 1e-5;
constexpr double share_of_tilt = 3e-6;
constexpr double share_of_magnitude = 0.2;
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

// The chance that a light that covers one direction covers another, `distance` apart as points on the
// unit sphere (fit_ltc).
double covered_together(double distance2) {
    const double distance = std::sqrt(distance2);
    return (1 - 0.5 * distance) / (1 + 0.8 * distance);
}

// Fewer lights reach below the horizon.
double lights_towards(const Vec3d& direction) {
    return 1 + direction.z / 3 - direction.z * direction.z / 20;
}

// What the sum holds beside the lobe itself.
double drawn_back(const LtcShape& shape) {
    return share_of_tilt * shape.tilt * shape.tilt +
           share_of_magnitude * shape.log_magnitude * shape.log_magnitude;
}

template <class Number>
double dot_product(const Number* a, const double* b, size_t count) {
    double sums[4] = {0, 0, 0, 0};
    size_t i = 0;
    for (; i + 4 <= count; i += 4)
        for (size_t lane = 0; lane < 4; ++lane) sums[lane] += double(a[i + lane]) * b[i + lane];
    for (; i < count; ++i) sums[0] += double(a[i]) * b[i];
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
    make_kernel();
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

// Lobes are even in y, so each direction stands for its mirror image as well.
void LobeDifference::make_kernel() {
    const size_t count = directions_.size();
    std::vector<double> x(count), y(count), z(count), factor(count);
    for (size_t i = 0; i < count; ++i) {
        x[i] = directions_[i].x;
        y[i] = directions_[i].y;
        z[i] = directions_[i].z;
        factor[i] = weights_[i] * lights_towards(directions_[i]);
    }
    kernel_.resize(count * (count + 1) / 2);
    float* row = kernel_.data();
    for (size_t i = 0; i < count; ++i) {
        for (size_t j = 0; j <= i; ++j) {
            const double in_plane = (x[i] - x[j]) * (x[i] - x[j]) + (z[i] - z[j]) * (z[i] - z[j]);
            const double near = covered_together(in_plane + (y[i] - y[j]) * (y[i] - y[j]));
            const double mirrored = covered_together(in_plane + (y[i] + y[j]) * (y[i] + y[j]));
            row[j] = static_cast<float>(0.5 * factor[i] * factor[j] * (near + mirrored));
        }
        row[i] *= 0.5F;
        row += i + 1;
    }
}

// Rows end at the diagonal, which is halved: the product of a with the whole matrix and b is that of
// lower_half(a) with b and the other way round.
std::vector<double> LobeDifference::lower_half(const std::vector<double>& values) const {
    std::vector<double> products(values.size());
    const float* row = kernel_.data();
    for (size_t i = 0; i < values.size(); row += ++i)
        products[i] = dot_product(row, values.data(), i + 1);
    return products;
}

double LobeDifference::value(const LtcShape& shape) const {
    const LtcInverse inverse = inverse_of(shape);
    const size_t count = directions_.size();
    std::vector<double> e(count);
    if (std::abs(shape.tilt) > largest_tilt) return std::numeric_limits<double>::infinity();
    const double magnitude = std::exp(shape.log_magnitude);
    double sum = drawn_back(shape);
    for (size_t i = 0; i < count; ++i) {
        e[i] = magnitude * ltc_density(inverse, directions_[i]) - densities_[i];
        sum += chi_weights_[i] * e[i] * e[i];
    }
    return sum + 2 * dot_product(lower_half(e).data(), e.data(), count);
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
    std::array<std::vector<double>, n + 1> halves;
    for (size_t a = 0; a <= n; ++a) {
        halves[a] = lower_half(columns[a]);
        for (size_t i = 0; i < count; ++i) halves[a][i] += 0.5 * chi_weights_[i] * columns[a][i];
    }
    std::array<std::array<double, n + 1>, n + 1> products{};
    for (size_t a = 0; a <= n; ++a)
        for (size_t b = a; b <= n; ++b)
            products[a][b] = products[b][a] =
                dot_product(halves[a].data(), columns[b].data(), count) +
                dot_product(halves[b].data(), columns[a].data(), count);
    products[0][0] += share_of_tilt;
    products[0][n] += share_of_tilt * shape.tilt;
    products[n - 1][n - 1] += share_of_magnitude;
    products[n - 1][n] += share_of_magnitude * shape.log_magnitude;
    products[n][n] += drawn_back(shape);
    Model model;
    model.value = products[n][n];
    for (size_t a = 0; a < n; ++a) {
        model.gradient[a] = products[a][n];
        for (size_t b = 0; b < n; ++b) model.hessian[a][b] = products[a][b];
    }
    return model;
}

}  // namespace splitsum
