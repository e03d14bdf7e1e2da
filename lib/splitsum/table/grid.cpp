#include "splitsum/table/grid.h"

#include <algorithm>
#include <cmath>

namespace splitsum {
namespace {

// A table of the other orientation whose texel (x, y) is `source` (x, y) or (y, x).
Table transposed(const Table& table) {
    Table other = blank_table(table.height, table.width, table.channels, table.layers);
    for (int layer = 0; layer < table.layers; ++layer)
        for (int y = 0; y < other.height; ++y)
            for (int x = 0; x < other.width; ++x)
                std::ranges::copy(table.texel(y, x, layer), other.texel(x, y, layer).begin());
    return other;
}

Table upside_down(const Table& table) {
    Table other = blank_table(table.width, table.height, table.channels, table.layers);
    for (int layer = 0; layer < table.layers; ++layer)
        for (int y = 0; y < table.height; ++y)
            for (int x = 0; x < table.width; ++x)
                std::ranges::copy(table.texel(x, table.height - 1 - y, layer),
                                  other.texel(x, y, layer).begin());
    return other;
}

}  // namespace

double n_dot_v_at(ViewAxis axis, double coordinate) {
    return axis == ViewAxis::cosine ? coordinate : 1 - coordinate * coordinate;
}

double coordinate_of_n_dot_v(ViewAxis axis, double n_dot_v) {
    return axis == ViewAxis::cosine ? n_dot_v : std::sqrt(std::max(0.0, 1 - n_dot_v));
}

double perceptual_roughness_at(RoughnessAxis axis, double coordinate) {
    return axis == RoughnessAxis::perceptual ? coordinate : std::sqrt(coordinate);
}

double coordinate_of_roughness(RoughnessAxis axis, double perceptual_roughness) {
    return axis == RoughnessAxis::perceptual ? perceptual_roughness
                                             : perceptual_roughness * perceptual_roughness;
}

double coordinate_of_texel(TexelLayout layout, int index, int size) {
    if (layout == TexelLayout::centre) return (index + 0.5) / size;
    return static_cast<double>(index) / (size - 1);
}

TableGrid grid_of(const TablePlan& plan, ViewAxis view_axis) {
    TableGrid grid;
    for (int i = 0; i < plan.size; ++i) {
        const double coordinate = coordinate_of_texel(plan.layout, i, plan.size);
        grid.n_dot_v.push_back(n_dot_v_at(view_axis, coordinate));
        grid.perceptual_roughness.push_back(
            perceptual_roughness_at(plan.roughness_axis, coordinate));
    }
    return grid;
}

Table arranged(const Table& canonical, const TablePlan& plan) {
    const Table table = plan.axes == TableAxes::nv_roughness ? canonical : transposed(canonical);
    return plan.flip ? upside_down(table) : table;
}

Table canonical_of(const Table& arranged, const TablePlan& plan) {
    const Table table = plan.flip ? upside_down(arranged) : arranged;
    return plan.axes == TableAxes::nv_roughness ? table : transposed(table);
}

}  // namespace splitsum
