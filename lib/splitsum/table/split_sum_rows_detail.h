#pragma once

#include <vector>

#include "splitsum/base/parallel.h"
#include "splitsum/table/split_sum.h"

namespace splitsum {

/// texel(n_dot_v, alpha) at every point of the grid, rows in parallel; stops when cancelled.
template <class Texel>
std::vector<SplitSum> split_sums_texel_by_texel(const TableGrid& grid, Progress& progress,
                                                const Texel& texel) {
    const size_t columns = grid.n_dot_v.size();
    std::vector<SplitSum> sums(columns * grid.perceptual_roughness.size());
    parallel_rows(static_cast<int>(grid.perceptual_roughness.size()), [&](int row) {
        if (progress.cancelled()) return;
        const double perceptual_roughness = grid.perceptual_roughness[static_cast<size_t>(row)];
        const double alpha = perceptual_roughness * perceptual_roughness;
        for (size_t x = 0; x < columns; ++x)
            sums[static_cast<size_t>(row) * columns + x] = texel(grid.n_dot_v[x], alpha);
        progress.advance(1);
    });
    return sums;
}

}  // namespace splitsum
