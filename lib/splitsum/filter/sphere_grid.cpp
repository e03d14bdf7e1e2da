#include "splitsum/filter/sphere_grid.h"

#include <algorithm>

namespace splitsum {

SphereGrid::SphereGrid(int rings, int columns)
    : rings_(rings),
      columns_(columns),
      points_(4 * size_t(rings + 2 * reach) * size_t(columns + 2 * reach)) {}

void SphereGrid::continue_edges() {
    const auto copy_ring = [&](int to, int from) {  // over a pole: half a circle further on
        const int half = columns_ / 2;
        std::copy_n(point(from, half), 4 * (columns_ - half), point(to, 0));
        std::copy_n(point(from, 0), 4 * half, point(to, columns_ - half));
    };
    for (int k = 0; k < reach; ++k) {
        copy_ring(-1 - k, k);
        copy_ring(rings_ + k, rings_ - 1 - k);
    }
    for (int k = -reach; k < rings_ + reach; ++k) {
        std::copy_n(point(k, columns_ - reach), 4 * reach, point(k, -reach));
        std::copy_n(point(k, 0), 4 * reach, point(k, columns_));
    }
}

}  // namespace splitsum
