#include "splitsum/table/split_sum_lookup.h"

#include <algorithm>

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

SplitSum mix(const SplitSum& from, const SplitSum& to, double fraction) {
    return {from.a + fraction * (to.a - from.a), from.b + fraction * (to.b - from.b)};
}

}  // namespace

SplitSum look_up(const Table& table, double n_dot_v, double perceptual_roughness) {
    const Between x = between_centres(std::clamp(n_dot_v, 0.0, 1.0), table.width);
    const Between y = between_centres(std::clamp(perceptual_roughness, 0.0, 1.0), table.height);
    const auto at = [&](int column, int row) {
        const size_t index = static_cast<size_t>(row) * static_cast<size_t>(table.width) +
                             static_cast<size_t>(column);
        const Vec2& texel = table.texels[index];
        return SplitSum{static_cast<double>(texel.x), static_cast<double>(texel.y)};
    };
    return mix(mix(at(x.low, y.low), at(x.high, y.low), x.fraction),
               mix(at(x.low, y.high), at(x.high, y.high), x.fraction), y.fraction);
}

}  // namespace splitsum
