#include "splitsum/table/albedo_tables.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "splitsum/base/parallel.h"
#include "splitsum/brdf/charlie_albedo.h"
#include "splitsum/brdf/disney_diffuse.h"
#include "splitsum/math/quadrature.h"
#include "splitsum/table/chebyshev.h"

namespace splitsum {
namespace {

// Columns in parallel: `fill(n_dot_v, values)` writes one value for every row of the grid.
template <class Fill>
Result<Table> bake_columns(const TableGrid& grid, Progress& progress, const Fill& fill) {
    const int columns = static_cast<int>(grid.n_dot_v.size());
    const int rows = static_cast<int>(grid.perceptual_roughness.size());
    Table table = blank_table(columns, rows, 1);
    progress.begin("directional albedo", columns);
    parallel_rows(columns, [&](int x) {
        if (progress.cancelled()) return;
        std::vector<double> values(grid.perceptual_roughness.size());
        fill(grid.n_dot_v[static_cast<size_t>(x)], values);
        for (int y = 0; y < rows; ++y)
            table.texel(x, y)[0] = static_cast<float>(values[static_cast<size_t>(y)]);
        progress.advance(1);
    });
    if (progress.cancelled())
        return Error{ErrorKind::interrupted, "the table was cancelled before its end"};
    return table;
}

std::vector<double> cloth_widths(const TableGrid& grid) {
    std::vector<double> widths;
    for (const double r : grid.perceptual_roughness)
        widths.push_back(std::clamp(r * r, narrowest_cloth_alpha, 1.0));
    return widths;
}

Result<Table> bake_cloth(const TablePlan& plan, const TableGrid& grid, Progress& progress,
                         ClothVisibility visibility) {
    const std::vector<double> widths = cloth_widths(grid);
    return bake_columns(grid, progress, [&](double n_dot_v, std::span<double> values) {
        const ClothAlbedo albedo(visibility, n_dot_v, quadrature_tolerance(plan));
        std::ranges::transform(widths, values.begin(),
                               [&](double alpha) { return albedo.at(alpha); });
    });
}

// Every width of the fitted Smith term is an integration of its own; over ln(alpha) so many of them
// know the others to 1e-6.
constexpr int widths_integrated = 32;

Result<Table> bake_smith_cloth(const TablePlan& plan, const TableGrid& grid, Progress& progress) {
    if (grid.perceptual_roughness.size() <= widths_integrated)
        return bake_cloth(plan, grid, progress, ClothVisibility::estevez_kulla);
    const LogChebyshev widths(narrowest_cloth_alpha, widths_integrated, cloth_widths(grid));
    return bake_columns(grid, progress, [&](double n_dot_v, std::span<double> values) {
        const ClothAlbedo albedo(ClothVisibility::estevez_kulla, n_dot_v,
                                 quadrature_tolerance(plan));
        std::vector<double> at_nodes;
        for (const double alpha : widths.nodes()) at_nodes.push_back(albedo.at(alpha));
        widths.spread(at_nodes, values);
    });
}

Result<Table> bake_diffuse(const TableGrid& grid, Progress& progress, DisneyDiffuse lobe) {
    return bake_columns(grid, progress, [&](double n_dot_v, std::span<double> values) {
        std::ranges::transform(grid.perceptual_roughness, values.begin(),
                               [&](double r) { return disney_diffuse_albedo(lobe, n_dot_v, r); });
    });
}

double error_of_value(double read, double exact) {
    return std::abs(read - exact) / std::max(1.0, exact);
}

double error_of_cloth(double n_dot_v, double perceptual_roughness, std::span<const double> read,
                      ClothVisibility visibility) {
    return error_of_value(
        read[0],
        charlie_albedo_exact(visibility, n_dot_v, perceptual_roughness * perceptual_roughness));
}

// Over light directions, which the closed form in the azimuth knows nothing of.
double error_of_diffuse(double n_dot_v, double perceptual_roughness, std::span<const double> read,
                        DisneyDiffuse lobe) {
    constexpr double pi = std::numbers::pi;
    const QuadratureRule rule = gauss_legendre(24);
    const double sin_v = std::sqrt((1 - n_dot_v) * (1 + n_dot_v));
    const double exact = integrate(rule, 0, 0.5 * pi, [&](double theta) {
        const double n_dot_l = std::cos(theta), sin_l = std::sin(theta);
        return n_dot_l * sin_l * integrate(rule, 0, 2 * pi, [&](double phi) {
                   return disney_diffuse(lobe, n_dot_l, n_dot_v,
                                         n_dot_l * n_dot_v + sin_l * sin_v * std::cos(phi),
                                         perceptual_roughness);
               });
    });
    return error_of_value(read[0], exact);
}

}  // namespace

Result<Table> bake_charlie(const TablePlan& plan, const TableGrid& grid, Progress& progress) {
    return bake_cloth(plan, grid, progress, ClothVisibility::neubelt);
}

double error_of_charlie(const TablePlan&, double n_dot_v, double perceptual_roughness,
                        std::span<const double> read) {
    return error_of_cloth(n_dot_v, perceptual_roughness, read, ClothVisibility::neubelt);
}

Result<Table> bake_charlie_clamped(const TablePlan& plan, const TableGrid& grid,
                                   Progress& progress) {
    return bake_cloth(plan, grid, progress, ClothVisibility::neubelt_clamped);
}

double error_of_charlie_clamped(const TablePlan&, double n_dot_v, double perceptual_roughness,
                                std::span<const double> read) {
    return error_of_cloth(n_dot_v, perceptual_roughness, read, ClothVisibility::neubelt_clamped);
}

Result<Table> bake_charlie_smith(const TablePlan& plan, const TableGrid& grid, Progress& progress) {
    return bake_smith_cloth(plan, grid, progress);
}

double error_of_charlie_smith(const TablePlan&, double n_dot_v, double perceptual_roughness,
                              std::span<const double> read) {
    return error_of_cloth(n_dot_v, perceptual_roughness, read, ClothVisibility::estevez_kulla);
}

Result<Table> bake_diffuse_disney(const TablePlan&, const TableGrid& grid, Progress& progress) {
    return bake_diffuse(grid, progress, DisneyDiffuse::burley);
}

double error_of_diffuse_disney(const TablePlan&, double n_dot_v, double perceptual_roughness,
                               std::span<const double> read) {
    return error_of_diffuse(n_dot_v, perceptual_roughness, read, DisneyDiffuse::burley);
}

Result<Table> bake_diffuse_renormalised(const TablePlan&, const TableGrid& grid,
                                        Progress& progress) {
    return bake_diffuse(grid, progress, DisneyDiffuse::renormalised);
}

double error_of_diffuse_renormalised(const TablePlan&, double n_dot_v, double perceptual_roughness,
                                     std::span<const double> read) {
    return error_of_diffuse(n_dot_v, perceptual_roughness, read, DisneyDiffuse::renormalised);
}

}  // namespace splitsum
