#include "splitsum/table/ggx_tables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "splitsum/math/quadrature.h"
#include "splitsum/table/average_albedo_exact.h"
#include "splitsum/table/split_sum.h"
#include "splitsum/table/split_sum_exact.h"

namespace splitsum {
namespace {

// A texel of two channels from a split sum.
using Pair = std::array<double, 2>;
using Form = Pair (*)(const SplitSum&);

Pair scale_and_bias(const SplitSum& sum) { return {sum.a, sum.b}; }
Pair bias_and_albedo(const SplitSum& sum) { return {sum.b, sum.a + sum.b}; }

Result<Table> bake_form(const TablePlan& plan, const TableGrid& grid, Progress& progress,
                        Form form) {
    const auto sums = split_sums(plan, grid, progress);
    if (!sums) return sums.error();
    Table table = blank_table(static_cast<int>(grid.n_dot_v.size()),
                              static_cast<int>(grid.perceptual_roughness.size()), 2);
    for (size_t i = 0; i < sums->size(); ++i) {
        const Pair pair = form((*sums)[i]);
        table.values[2 * i] = static_cast<float>(pair[0]);
        table.values[2 * i + 1] = static_cast<float>(pair[1]);
    }
    return table;
}

double error_of_form(const TablePlan& plan, double n_dot_v, double perceptual_roughness,
                     std::span<const double> read, Form form) {
    const Pair exact =
        form(split_sum_exact(plan.geometry, n_dot_v, perceptual_roughness * perceptual_roughness));
    return std::max(std::abs(read[0] - exact[0]), std::abs(read[1] - exact[1]));
}

// Nodes mu and weights of the integral 2 ∫ f mu dmu over [0, 1]: Gauss points in ln(mu), where
// albedos are smooth (chebyshev.h), down to views that weigh nothing any more.
struct AverageRule {
    std::vector<double> nodes;
    std::vector<double> weights;
};

AverageRule average_rule() {
    constexpr int count = 48;
    constexpr double most_grazing = 1e-5;  // those below weigh 1e-10
    const double length = std::log(1 / most_grazing);
    const QuadratureRule gauss = gauss_legendre(count);
    AverageRule rule;
    for (size_t i = 0; i < gauss.nodes.size(); ++i) {
        const double mu = std::exp(-0.5 * length * (1 - gauss.nodes[i]));
        rule.nodes.push_back(mu);
        rule.weights.push_back(length * gauss.weights[i] * mu * mu);
    }
    return rule;
}

// The grid with columns for the average behind its own.
TableGrid with_columns(TableGrid grid, const std::vector<double>& more) {
    grid.n_dot_v.insert(grid.n_dot_v.end(), more.begin(), more.end());
    return grid;
}

double albedo_of(const SplitSum& sum) { return sum.a + sum.b; }

// 2 ∫ f mu dmu over [0, 1] of what is linear between `values` at ascending `places`, and constant beyond.
double average_as_read(const std::vector<double>& places, const std::vector<double>& values) {
    const double first = places.front(), last = places.back();
    double sum = values.front() * first * first + values.back() * (1 - last * last);
    for (size_t i = 0; i + 1 < places.size(); ++i) {
        const double a = places[i], b = places[i + 1];
        sum += (b - a) / 3 * (values[i] * (2 * a + b) + values[i + 1] * (a + 2 * b));
    }
    return sum;
}

}  // namespace

Result<Table> bake_ggx(const TablePlan& plan, const TableGrid& grid, Progress& progress) {
    return bake_form(plan, grid, progress, scale_and_bias);
}

double error_of_ggx(const TablePlan& plan, double n_dot_v, double perceptual_roughness,
                    std::span<const double> read) {
    return error_of_form(plan, n_dot_v, perceptual_roughness, read, scale_and_bias);
}

Result<Table> bake_ggx_multiscatter(const TablePlan& plan, const TableGrid& grid,
                                    Progress& progress) {
    return bake_form(plan, grid, progress, bias_and_albedo);
}

double error_of_ggx_multiscatter(const TablePlan& plan, double n_dot_v, double perceptual_roughness,
                                 std::span<const double> read) {
    return error_of_form(plan, n_dot_v, perceptual_roughness, read, bias_and_albedo);
}

Result<Table> bake_energy(const TablePlan& plan, const TableGrid& grid, Progress& progress) {
    const AverageRule rule = average_rule();
    const auto sums = split_sums(plan, with_columns(grid, rule.nodes), progress);
    if (!sums) return sums.error();
    const size_t columns = grid.n_dot_v.size(), rows = grid.perceptual_roughness.size();
    Table table = blank_table(static_cast<int>(columns), static_cast<int>(rows), 2);
    for (size_t y = 0; y < rows; ++y) {
        const SplitSum* row = sums->data() + y * (columns + rule.nodes.size());
        double average = 0;
        for (size_t i = 0; i < rule.nodes.size(); ++i)
            average += rule.weights[i] * albedo_of(row[columns + i]);
        for (size_t x = 0; x < columns; ++x) {
            table.values[2 * (y * columns + x)] = static_cast<float>(albedo_of(row[x]));
            table.values[2 * (y * columns + x) + 1] = static_cast<float>(average);
        }
    }
    return table;
}

double error_of_energy(const TablePlan& plan, double n_dot_v, double perceptual_roughness,
                       std::span<const double> read) {
    const double alpha = perceptual_roughness * perceptual_roughness;
    const double albedo = albedo_of(split_sum_exact(plan.geometry, n_dot_v, alpha));
    return std::max(std::abs(read[0] - albedo),
                    std::abs(read[1] - average_albedo_exact(plan.geometry, alpha)));
}

Result<Table> bake_energy_lost(const TablePlan& plan, const TableGrid& grid, Progress& progress) {
    const auto sums = split_sums(plan, grid, progress);
    if (!sums) return sums.error();
    const size_t columns = grid.n_dot_v.size(), rows = grid.perceptual_roughness.size();
    Table table = blank_table(static_cast<int>(columns), static_cast<int>(rows), 2);
    std::vector<double> lost(columns);
    for (size_t y = 0; y < rows; ++y) {
        // Below 0 it is what the quadrature leaves, and would cancel in the average of smooth rows.
        for (size_t x = 0; x < columns; ++x)
            lost[x] = std::max(0.0, 1 - albedo_of((*sums)[y * columns + x]));
        const double average = average_as_read(grid.n_dot_v, lost);
        for (size_t x = 0; x < columns; ++x) {
            table.values[2 * (y * columns + x)] = static_cast<float>(lost[x]);
            table.values[2 * (y * columns + x) + 1] = static_cast<float>(average);
        }
    }
    return table;
}

double error_of_energy_lost(const TablePlan& plan, double n_dot_v, double perceptual_roughness,
                            std::span<const double> read) {
    const std::array<double, 2> kept = {1 - read[0], 1 - read[1]};
    return error_of_energy(plan, n_dot_v, perceptual_roughness, kept);
}

}  // namespace splitsum
