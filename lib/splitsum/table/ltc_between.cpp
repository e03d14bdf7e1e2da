#include "splitsum/table/ltc_between.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "splitsum/math/quadrature.h"

namespace splitsum {
namespace {

// Of perceptual roughness: the first two rows of 64.
constexpr double mirrors_below = 0.02;

// 1 up to `all` and 0 from `none` on.
double fading(double perceptual_roughness, double all, double none) {
    return std::clamp((none - perceptual_roughness) / (none - all), 0.0, 1.0);
}

double straightened(double before, double m, double after) {
    return m - (before - 2 * m + after) / 12;
}

void straighten_row(std::span<LtcInverse> row) {
    const std::vector<LtcInverse> found(row.begin(), row.end());
    for (size_t i = 1; i + 1 < row.size(); ++i) {
        const LtcInverse &a = found[i - 1], &m = found[i], &b = found[i + 1];
        const LtcInverse moved{.m00 = straightened(a.m00, m.m00, b.m00),
                               .m20 = straightened(a.m20, m.m20, b.m20),
                               .m02 = straightened(a.m02, m.m02, b.m02),
                               .m22 = straightened(a.m22, m.m22, b.m22)};
        if (determinant(moved) > 0) row[i] = moved;
    }
}

// With t = sqrt(1 - n·v) the mirror direction is 2 asin(t / sqrt(2)) from the normal. Between two vectors
// along it, of lengths g and g (1 + e), a linear filter turns by w + e w (1 - w) of the way, w its
// weight; that follows the angle where 2 g' / g is the derivative of log(angle'), taken negative:
// g = (1 - t² / 2)^(1/4).
void turn_evenly(std::span<LtcInverse> row, std::span<const double> n_dot_v) {
    for (size_t i = 0; i < row.size(); ++i) {
        const double factor =
            std::pow(0.5 * (1 + n_dot_v[i]), 0.25) / std::hypot(row[i].m00, row[i].m02);
        row[i].m00 *= factor;
        row[i].m02 *= factor;
    }
}

void point_along_horizon(LtcInverse& edge_on, const LtcInverse& neighbour, double share) {
    LtcInverse moved = edge_on;
    moved.m00 *= 1 - share;
    moved.m02 += share * (neighbour.m02 - edge_on.m02);
    if (determinant(moved) > 0) edge_on = moved;
}

}  // namespace

void fit_between_views(std::span<LtcInverse> matrices, const TableGrid& grid) {
    const size_t columns = grid.n_dot_v.size();
    for (size_t y = 0; y < grid.perceptual_roughness.size(); ++y) {
        const double r = grid.perceptual_roughness[y];
        const auto row = matrices.subspan(y * columns, columns);
        // Views are in the order of the axis: with texels at its ends the last is seen edge on, and the
        // interval before it is exact with the neighbour as it is.
        const bool ends_edge_on = columns > 1 && grid.n_dot_v.back() == 0;
        if (r < mirrors_below)
            turn_evenly(row, grid.n_dot_v);
        else
            straighten_row(ends_edge_on ? row.first(columns - 1) : row);
        if (ends_edge_on) point_along_horizon(row.back(), row[columns - 2], fading(r, 0.05, 0.12));
    }
}

LastInterval last_interval(const TableGrid& grid) {
    constexpr int nodes = 12;
    LastInterval interval;
    const size_t columns = grid.n_dot_v.size();
    if (columns < 2 || grid.n_dot_v.back() != 0) return interval;
    const auto coordinate = [](double n_dot_v) {
        return coordinate_of_n_dot_v(ViewAxis::sqrt_one_minus_cosine, n_dot_v);
    };
    const double first = grid.n_dot_v[columns - 2], start = coordinate(first);
    const QuadratureRule rule = gauss_legendre(nodes);
    for (size_t i = 0; i < rule.nodes.size(); ++i) {
        const double n_dot_v = 0.5 * first * (1 + rule.nodes[i]);
        interval.n_dot_v.push_back(n_dot_v);
        interval.at_edge.push_back((coordinate(n_dot_v) - start) / (1 - start));
        interval.weights.push_back(rule.weights[i]);
    }
    return interval;
}

double value_edge_on(const LastInterval& interval, double neighbour,
                     std::span<const double> exact) {
    double product = 0, square = 0;
    for (size_t i = 0; i < exact.size(); ++i) {
        const double share = interval.at_edge[i];
        product += interval.weights[i] * share * (exact[i] - (1 - share) * neighbour);
        square += interval.weights[i] * share * share;
    }
    return std::clamp(product / square, 0.0, 1.0);
}

}  // namespace splitsum
