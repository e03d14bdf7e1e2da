#include "splitsum/table/ltc_tables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "splitsum/brdf/disney_diffuse.h"
#include "splitsum/ltc/clipped_sphere.h"
#include "splitsum/ltc/ltc_table.h"
#include "splitsum/ltc/polygon_light.h"
#include "splitsum/ltc/polygon_reference.h"
#include "splitsum/table/ltc_between.h"
#include "splitsum/table/ltc_lookup.h"
#include "splitsum/table/split_sum.h"
#include "splitsum/table/split_sum_exact.h"

namespace splitsum {
namespace {

// The integrals that the first two channels of layer 1 hold, times the magnitude of a fit.
struct Magnitude {
    double albedo;
    double weighted;
};

// The lobes that are fitted are those of the height-correlated term, by the default method.
TablePlan plan_of_magnitude(const TablePlan& plan) {
    TablePlan fixed = plan;
    fixed.geometry = SmithTerm::height_correlated;
    fixed.method = TablePlan{}.method;
    return fixed;
}

// Moves the magnitudes at n·v = 0 so that they are right between there and the neighbour as well.
Status fit_edge_on(const TablePlan& plan, const TableGrid& grid, std::span<Magnitude> magnitudes) {
    const LastInterval interval = last_interval(grid);
    const size_t nodes = interval.n_dot_v.size(), columns = grid.n_dot_v.size();
    if (nodes == 0) return Done{};
    NoProgress progress;  // a fraction of what went before
    const auto exact = split_sums(plan, {interval.n_dot_v, grid.perceptual_roughness}, progress);
    if (!exact) return exact.error();
    for (size_t row = 0; row < grid.perceptual_roughness.size(); ++row) {
        std::vector<double> albedo, weighted;
        for (const SplitSum& sum : std::span(*exact).subspan(row * nodes, nodes)) {
            albedo.push_back(sum.a + sum.b);
            weighted.push_back(sum.b);
        }
        const Magnitude& neighbour = magnitudes[row * columns + columns - 2];
        magnitudes[row * columns + columns - 1] = {
            value_edge_on(interval, neighbour.albedo, albedo),
            value_edge_on(interval, neighbour.weighted, weighted)};
    }
    return Done{};
}

Result<std::vector<Magnitude>> magnitudes(LtcTarget target, const TablePlan& plan,
                                          const TableGrid& grid, Progress& progress) {
    std::vector<Magnitude> found;
    if (target == LtcTarget::disney_diffuse) {
        for (const double r : grid.perceptual_roughness)
            for (const double n_dot_v : grid.n_dot_v)
                found.push_back({disney_diffuse_albedo(DisneyDiffuse::burley, n_dot_v, r), 0});
        return found;
    }
    const auto sums = split_sums(plan_of_magnitude(plan), grid, progress);
    if (!sums) return sums.error();
    for (const SplitSum& sum : *sums) found.push_back({sum.a + sum.b, sum.b});
    const Status fitted = fit_edge_on(plan_of_magnitude(plan), grid, found);
    if (!fitted) return fitted.error();
    return found;
}

double sphere_at(const TablePlan& plan, double n_dot_v, double perceptual_roughness) {
    return clipped_sphere_ratio(
        2 * coordinate_of_roughness(plan.roughness_axis, perceptual_roughness) - 1,
        coordinate_of_n_dot_v(ViewAxis::sqrt_one_minus_cosine, n_dot_v));
}

Result<Table> bake_ltc(LtcTarget target, const TablePlan& plan, const TableGrid& grid,
                       Progress& progress) {
    const auto magnitude = magnitudes(target, plan, grid, progress);
    if (!magnitude) return magnitude.error();
    progress.begin("transformed cosines", static_cast<int>(grid.n_dot_v.size()));
    const auto fits = fit_ltc_table(target, grid.n_dot_v, grid.perceptual_roughness, progress);
    if (!fits) return fits.error();
    std::vector<LtcInverse> inverse;
    for (const LtcFit& fit : *fits) inverse.push_back(fit.inverse);
    if (target == LtcTarget::ggx) fit_between_views(inverse, grid);

    const int columns = static_cast<int>(grid.n_dot_v.size());
    const int rows = static_cast<int>(grid.perceptual_roughness.size());
    Table table = blank_table(columns, rows, 4, 2);
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            const auto at = static_cast<size_t>(y) * grid.n_dot_v.size() + static_cast<size_t>(x);
            const LtcInverse& m = inverse[at];
            const double sphere = sphere_at(plan, grid.n_dot_v[static_cast<size_t>(x)],
                                            grid.perceptual_roughness[static_cast<size_t>(y)]);
            std::ranges::transform(std::array{m.m00, m.m20, m.m02, m.m22},
                                   table.texel(x, y, 0).begin(),
                                   [](double value) { return static_cast<float>(value); });
            std::ranges::transform(
                std::array{(*fits)[at].magnitude * (*magnitude)[at].albedo,
                           (*fits)[at].magnitude * (*magnitude)[at].weighted, 0.0, sphere},
                table.texel(x, y, 1).begin(),
                [](double value) { return static_cast<float>(value); });
        }
    return table;
}

using Polygon = std::vector<Vec3d>;

// A panel where a mirror would show it, one beside it, a triangle overhead, a wall that stands on the
// horizon, and a small light behind the viewer.
const std::vector<Polygon>& judging_lights() {
    static const std::vector<Polygon> lights = {
        {{-1.5, -0.6, 0.3}, {-1.3, 0.9, 0.3}, {-0.9, 0.8, 1.4}, {-1.1, -0.7, 1.5}},
        {{-0.9, 0.4, 0.1}, {-0.2, 1.2, 0.2}, {-0.3, 1.1, 1.0}, {-0.8, 0.5, 0.9}},
        {{-0.8, -0.6, 1.0}, {0.7, -0.4, 1.1}, {-0.1, 1.0, 0.9}},
        {{-1.0, -1.4, -0.5}, {-1.2, 0.3, -0.4}, {-1.1, 0.2, 0.6}, {-1.0, -1.5, 0.8}},
        {{0.9, -0.1, 0.6}, {0.9, 0.2, 0.6}, {0.8, 0.2, 0.9}, {0.8, -0.1, 0.9}},
    };
    return lights;
}

double error_of_ltc(LtcTarget target, double n_dot_v, double perceptual_roughness,
                    std::span<const double> read) {
    Magnitude exact{disney_diffuse_albedo(DisneyDiffuse::burley, n_dot_v, perceptual_roughness), 0};
    if (target == LtcTarget::ggx) {
        const SplitSum sum = split_sum_exact(SmithTerm::height_correlated, n_dot_v,
                                             perceptual_roughness * perceptual_roughness);
        exact = {sum.a + sum.b, sum.b};
    }
    double error = std::max(std::abs(read[4] - exact.albedo), std::abs(read[5] - exact.weighted));
    const LtcInverse inverse = ltc_inverse(read);
    const TargetLobe lobe(target, n_dot_v, perceptual_roughness);
    for (const Polygon& light : judging_lights())
        error =
            std::max(error, std::abs(ltc_reflectance(read, 1) * ltc_polygon_light(inverse, light) -
                                     polygon_light_reference(lobe, light)));
    return error;
}

}  // namespace

Result<Table> bake_ltc_ggx(const TablePlan& plan, const TableGrid& grid, Progress& progress) {
    return bake_ltc(LtcTarget::ggx, plan, grid, progress);
}

double error_of_ltc_ggx(const TablePlan&, double n_dot_v, double perceptual_roughness,
                        std::span<const double> read) {
    return error_of_ltc(LtcTarget::ggx, n_dot_v, perceptual_roughness, read);
}

Result<Table> bake_ltc_disney(const TablePlan& plan, const TableGrid& grid, Progress& progress) {
    return bake_ltc(LtcTarget::disney_diffuse, plan, grid, progress);
}

double error_of_ltc_disney(const TablePlan&, double n_dot_v, double perceptual_roughness,
                           std::span<const double> read) {
    return error_of_ltc(LtcTarget::disney_diffuse, n_dot_v, perceptual_roughness, read);
}

}  // namespace splitsum
