#include "splitsum/table/bilinear.h"

#include <algorithm>
#include <cassert>

namespace splitsum {
namespace {

// Between which two texels of an axis a coordinate lies, and how far it is on the way.
struct Between {
    int low;
    int high;
    double fraction;
};

Between between_centres(double coordinate, int size) {
    const double position = std::clamp(coordinate * size - 0.5, 0.0, size - 1.0);
    const int low = static_cast<int>(position);
    return {low, std::min(low + 1, size - 1), position - low};
}

double mix(double from, double to, double fraction) { return from + fraction * (to - from); }

// Where a sampler finds the value of an axis: with texels at the ends the axis covers one texel less.
double sampler_coordinate(TexelLayout layout, double coordinate, int size) {
    if (layout == TexelLayout::centre) return coordinate;
    return (coordinate * (size - 1) + 0.5) / size;
}

}  // namespace

void read_bilinear(const Table& table, const Vec2d& coordinates, std::span<double> read) {
    assert(read.size() == static_cast<size_t>(table.channels * table.layers));
    const Between x = between_centres(coordinates.x, table.width);
    const Between y = between_centres(coordinates.y, table.height);
    for (int layer = 0; layer < table.layers; ++layer)
        for (int channel = 0; channel < table.channels; ++channel) {
            const auto at = [&](int column, int row) {
                return static_cast<double>(
                    table.texel(column, row, layer)[static_cast<size_t>(channel)]);
            };
            read[static_cast<size_t>(layer * table.channels + channel)] =
                mix(mix(at(x.low, y.low), at(x.high, y.low), x.fraction),
                    mix(at(x.low, y.high), at(x.high, y.high), x.fraction), y.fraction);
        }
}

Vec2d texture_coordinates(const TablePlan& plan, int size, ViewAxis view_axis, double n_dot_v,
                          double perceptual_roughness) {
    const auto placed = [&](double coordinate) {
        return sampler_coordinate(plan.layout, std::clamp(coordinate, 0.0, 1.0), size);
    };
    const double view = placed(coordinate_of_n_dot_v(view_axis, std::clamp(n_dot_v, 0.0, 1.0)));
    const double rough = placed(
        coordinate_of_roughness(plan.roughness_axis, std::clamp(perceptual_roughness, 0.0, 1.0)));
    const bool view_first = plan.axes == TableAxes::nv_roughness;
    const Vec2d upright = view_first ? Vec2d(view, rough) : Vec2d(rough, view);
    return plan.flip ? Vec2d(upright.x, 1 - upright.y) : upright;
}

}  // namespace splitsum
