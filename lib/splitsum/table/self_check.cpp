#include "splitsum/table/self_check.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "splitsum/base/parallel.h"
#include "splitsum/math/low_discrepancy.h"
#include "splitsum/table/bilinear.h"

namespace splitsum {
namespace {

// A point of the table as a renderer names it.
struct Lookup {
    double n_dot_v;
    double perceptual_roughness;
};

Lookup texel_of(const TableGrid& grid, int x, int y) {
    return {grid.n_dot_v[static_cast<size_t>(x)],
            grid.perceptual_roughness[static_cast<size_t>(y)]};
}

// The corners and edges, where tables fail, and Hammersley points inside.
std::vector<Lookup> texels_to_judge(const TableGrid& grid, const TableProbes& probes) {
    const int last = static_cast<int>(grid.n_dot_v.size()) - 1;
    std::vector<Lookup> texels;
    for (int i = 0; i < probes.along_edge; ++i) {
        const int at = last * i / std::max(1, probes.along_edge - 1);
        for (const auto& [x, y] : {std::pair(at, 0), {at, last}, {0, at}, {last, at}})
            texels.push_back(texel_of(grid, x, y));
    }
    for (int i = 0; i < probes.texels; ++i) {
        const Vec2d point =
            hammersley(static_cast<uint32_t>(i), static_cast<uint32_t>(probes.texels));
        texels.push_back(texel_of(grid, static_cast<int>(point.x * (last + 1)),
                                  static_cast<int>(point.y * (last + 1))));
    }
    return texels;
}

// Point i of the additive sequence of the plastic number (Roberts 2018, "The Unreasonable
// Effectiveness of Quasirandom Sequences"): even, and on no grid that a table could have.
Vec2d spread_point(int i) {
    constexpr double plastic = 1.32471795724474602596;
    const double x = 0.5 + i / plastic, y = 0.5 + i / (plastic * plastic);
    return {x - std::floor(x), y - std::floor(y)};
}

// A point in coordinates of the axes.
Lookup lookup_at(const TableKind& kind, const TablePlan& plan, const Vec2d& coordinates) {
    return {n_dot_v_at(kind.view_axis, coordinates.x),
            perceptual_roughness_at(plan.roughness_axis, coordinates.y)};
}

std::vector<Lookup> points_between(const TableKind& kind, const TablePlan& plan, int count) {
    const double first = coordinate_of_texel(plan.layout, 0, plan.size);
    const double last = coordinate_of_texel(plan.layout, plan.size - 1, plan.size);
    std::vector<Lookup> points;
    for (int i = 0; i < count; ++i)
        points.push_back(lookup_at(kind, plan, first + (last - first) * spread_point(i)));
    return points;
}

std::vector<Lookup> points_in_rim(const TableKind& kind, const TablePlan& plan, int count) {
    std::vector<Lookup> points;
    if (plan.layout == TexelLayout::edge || kind.is_closed_form()) return points;
    for (int i = 0; i < count; ++i) {
        const double along = spread_point(i).x;
        const Vec2d sides[] = {{0, along}, {1, along}, {along, 0}, {along, 1}};
        points.push_back(lookup_at(kind, plan, sides[i % 4]));
    }
    return points;
}

double worst_error(const TableKind& kind, const TablePlan& plan, const Table& stored,
                   const std::vector<Lookup>& lookups) {
    const auto channels = static_cast<size_t>(stored.channels * stored.layers);
    std::vector<double> errors(lookups.size());
    parallel_rows(static_cast<int>(lookups.size()), [&](int i) {
        const auto& [n_dot_v, perceptual_roughness] = lookups[static_cast<size_t>(i)];
        std::vector<double> read(channels);
        read_bilinear(
            stored,
            texture_coordinates(plan, stored.width, kind.view_axis, n_dot_v, perceptual_roughness),
            read);
        errors[static_cast<size_t>(i)] = kind.error_of(plan, n_dot_v, perceptual_roughness, read);
    });
    return lookups.empty() ? 0 : *std::ranges::max_element(errors);
}

}  // namespace

TableCheck check_table(const TableKind& kind, const TablePlan& plan, const Table& stored,
                       const TableProbes& probes) {
    const auto texels = texels_to_judge(grid_of(plan, kind.view_axis), probes);
    const auto points = points_between(kind, plan, probes.points);
    const auto rim = points_in_rim(kind, plan, probes.rim_points);
    const auto worst = [&](const std::vector<Lookup>& lookups) {
        return worst_error(kind, plan, stored, lookups);
    };
    return {worst(texels),
            worst(points),
            worst(rim),
            static_cast<int>(texels.size()),
            static_cast<int>(points.size()),
            static_cast<int>(rim.size())};
}

}  // namespace splitsum
