#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "splitsum/base/random.h"
#include "splitsum/base/text.h"
#include "splitsum/math/quadrature.h"
#include "splitsum/math/vec.h"
#include "support/incomplete_gamma.h"

namespace splitsum::tests {

/// How well samples of the sphere follow a density: Pearson's chi-square over cells.
struct ChiSquareFit {
    double statistic = 0;
    int degrees_of_freedom = 0;
    double p_value = 0;       ///< how often a right sampler would fit worse than this
    double pdf_integral = 0;  ///< of the density over the sphere; 1 for a right one
    std::string worst;        ///< the cell that contributes most
};

/// The p-value below which one of `tests` independent right samplers falls with a probability of
/// `significance` in all (Šidák 1967).
inline double sidak_threshold(size_t tests, double significance = 0.01) {
    return 1 - std::pow(1 - significance, 1.0 / static_cast<double>(tests));
}

namespace sphere_cells {

inline constexpr int rows = 64;     // of theta, from +z
inline constexpr int columns = 32;  // of phi
inline constexpr double row_height = std::numbers::pi / rows;
inline constexpr double column_width = 2 * std::numbers::pi / columns;

inline size_t cell_of(const Vec3d& direction) {
    const double theta = std::atan2(std::hypot(direction.x, direction.y), direction.z);
    const double phi = std::atan2(direction.y, direction.x) + std::numbers::pi;
    const int row = std::min(rows - 1, static_cast<int>(theta / row_height));
    const int column = std::min(columns - 1, static_cast<int>(phi / column_width));
    return static_cast<size_t>(row * columns + column);
}

template <class Pdf>
double integral_over(int row, int column, const QuadratureRule& rule, const Pdf& pdf) {
    const auto over_phi = [&](double theta) {
        const double phi = column * column_width - std::numbers::pi;
        return std::sin(theta) * integrate(rule, phi, phi + column_width, [&](double p) {
                   return pdf(Vec3d(std::sin(theta) * std::cos(p), std::sin(theta) * std::sin(p),
                                    std::cos(theta)));
               });
    };
    return integrate(rule, row * row_height, (row + 1) * row_height, over_phi);
}

}  // namespace sphere_cells

/// Cells whose expectation is too small for the statistic (below 5) are counted as one.
struct PooledCounts {
    std::vector<double> expected;
    std::vector<double> observed;
    std::vector<std::string> names;
};

inline PooledCounts pool_cells(const std::vector<double>& expected,
                               const std::vector<double>& observed) {
    PooledCounts pooled{{0}, {0}, {"all cells of low expectation"}};
    for (size_t cell = 0; cell < expected.size(); ++cell) {
        if (expected[cell] < 5) {
            pooled.expected[0] += expected[cell];
            pooled.observed[0] += observed[cell];
            continue;
        }
        pooled.expected.push_back(expected[cell]);
        pooled.observed.push_back(observed[cell]);
        pooled.names.push_back(cat("theta row ", cell / sphere_cells::columns, ", phi column ",
                                   cell % sphere_cells::columns));
    }
    // A pool that is itself too small joins the first cell, so that no sample goes uncounted.
    if (pooled.expected[0] < 5 && pooled.expected.size() > 1) {
        pooled.expected[1] += pooled.expected[0];
        pooled.observed[1] += pooled.observed[0];
        pooled.expected.erase(pooled.expected.begin());
        pooled.observed.erase(pooled.observed.begin());
        pooled.names.erase(pooled.names.begin());
    }
    return pooled;
}

inline ChiSquareFit fit_of(const PooledCounts& counts) {
    ChiSquareFit fit;
    double largest = -1;
    for (size_t i = 0; i < counts.expected.size(); ++i) {
        const double difference = counts.observed[i] - counts.expected[i];
        const double share = difference * difference / counts.expected[i];
        fit.statistic += share;
        if (share <= largest) continue;
        largest = share;
        fit.worst = cat(counts.names[i], ": ", counts.observed[i], " samples, ", counts.expected[i],
                        " expected");
    }
    fit.degrees_of_freedom = static_cast<int>(counts.expected.size()) - 1;
    fit.p_value = upper_incomplete_gamma(0.5 * fit.degrees_of_freedom, 0.5 * fit.statistic);
    return fit;
}

/// Draws `count` directions sampler(u), u uniform in [0, 1)² and a function of `seed` alone, and
/// compares their numbers in cells of (theta, phi) about +z with the integrals of pdf(direction).
/// Lobes must be wider than about 0.05 radians, a cell's height.
template <class Sampler, class Pdf>
ChiSquareFit chi_square_fit(const Sampler& sampler, const Pdf& pdf, int count, uint32_t seed) {
    using namespace sphere_cells;
    std::vector<double> observed(static_cast<size_t>(rows * columns), 0.0);
    const uint32_t first_key = mix_bits(seed);
    for (uint32_t i = 0; i < static_cast<uint32_t>(count); ++i) {
        const Vec2d u(static_cast<double>(unit_float(first_key + 2 * i)),
                      static_cast<double>(unit_float(first_key + 2 * i + 1)));
        ++observed[cell_of(sampler(u))];
    }
    const QuadratureRule rule = gauss_legendre(10);
    std::vector<double> expected;
    expected.reserve(observed.size());
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            expected.push_back(count * integral_over(row, column, rule, pdf));

    ChiSquareFit fit = fit_of(pool_cells(expected, observed));
    fit.pdf_integral = std::accumulate(expected.begin(), expected.end(), 0.0) / count;
    return fit;
}

}  // namespace splitsum::tests
