#include "splitsum/table/ggx_tables.h"

#include <algorithm>
#include <cmath>

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

}  // namespace splitsum
