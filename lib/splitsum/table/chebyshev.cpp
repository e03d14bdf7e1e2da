#include "splitsum/table/chebyshev.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace splitsum {

LogChebyshev::LogChebyshev(double lowest, int count, std::span<const double> points)
    : point_count_(points.size()) {
    const double length = std::log(1 / lowest);
    std::vector<double> positions, barycentric;  // in [-1, 1]
    for (int k = 0; k < count; ++k) {
        const double angle = (k + 0.5) * std::numbers::pi / count;
        positions.push_back(std::cos(angle));
        barycentric.push_back((k % 2 == 0 ? 1 : -1) * std::sin(angle));
        nodes_.push_back(std::exp(-0.5 * length * (1 - positions.back())));
    }
    weights_.resize(nodes_.size() * point_count_);
    for (size_t i = 0; i < point_count_; ++i) {
        const double position = 1 + 2 * std::log(points[i]) / length;
        const auto quotient = [&](size_t k) {
            // At a node the quotient is all there is; a distance of 1e-300 says the same.
            const double distance = position - positions[k];
            return barycentric[k] / (distance == 0 ? 1e-300 : distance);
        };
        double sum = 0;
        for (size_t k = 0; k < nodes_.size(); ++k) sum += quotient(k);
        for (size_t k = 0; k < nodes_.size(); ++k)
            weights_[k * point_count_ + i] = quotient(k) / sum;
    }
}

void LogChebyshev::spread(std::span<const double> values, std::span<double> out) const {
    std::ranges::fill(out, 0.0);
    for (size_t k = 0; k < nodes_.size(); ++k) {
        const double* weights = weights_.data() + k * point_count_;
        for (size_t i = 0; i < point_count_; ++i) out[i] += weights[i] * values[k];
    }
}

double LogChebyshev::at_point(std::span<const double> values, size_t i) const {
    double sum = 0;
    for (size_t k = 0; k < nodes_.size(); ++k) sum += weights_[k * point_count_ + i] * values[k];
    return sum;
}

int log_chebyshev_nodes(double lowest, double tolerance) {
    const double length = std::log(1 / lowest);
    return 2 + static_cast<int>(std::ceil(std::log(1 / tolerance) * length * std::numbers::inv_pi));
}

}  // namespace splitsum
