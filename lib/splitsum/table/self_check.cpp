#include "splitsum/table/self_check.h"

#include <algorithm>
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

std::vector<Lookup> points_to_judge(int count) {
    std::vector<Lookup> points;
    for (int i = 0; i < count; ++i) {
        const Vec2d point = hammersley(static_cast<uint32_t>(i), static_cast<uint32_t>(count));
        points.push_back({point.x, point.y});
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
    const auto points = points_to_judge(probes.points);
    return {worst_error(kind, plan, stored, texels), worst_error(kind, plan, stored, points),
            static_cast<int>(texels.size()), static_cast<int>(points.size())};
}

}  // namespace splitsum
