#pragma once

#include <span>
#include <vector>

namespace splitsum {

/// Interpolation over [lowest, 1], 0 < lowest < 1, by the polynomial in ln x through the Chebyshev
/// points of the first kind: for functions that are smooth in the logarithm, like albedos in n·v,
/// whose singularities lie on the imaginary axis and at 0. With l = ln(1 / lowest) those are pi / 2
/// from an interval of length l, and the error falls as exp(-n pi / l).
class LogChebyshev {
public:
    /// Evaluates at `points`, each in [lowest, 1], from `count` nodes. The weights of all nodes at
    /// every point are made here, by the barycentric formula (Berrut & Trefethen 2004, SIAM Review
    /// 46(3)), once for many functions.
    LogChebyshev(double lowest, int count, std::span<const double> points);

    /// The nodes, in (lowest, 1).
    const std::vector<double>& nodes() const { return nodes_; }

    /// The polynomial through values[k] at nodes()[k], at every point: out has as many elements.
    void spread(std::span<const double> values, std::span<double> out) const;

    /// The same at point i alone.
    double at_point(std::span<const double> values, size_t i) const;

private:
    size_t point_count_;
    std::vector<double> nodes_;
    std::vector<double> weights_;  // [node][point]
};

/// How many nodes an error of `tolerance` needs, for functions whose nearest singularities are those.
int log_chebyshev_nodes(double lowest, double tolerance);

}  // namespace splitsum
