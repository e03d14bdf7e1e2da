#pragma once

#include <vector>

#include "splitsum/math/vec.h"
#include "splitsum/sphere/environment.h"

namespace splitsum {

/// Averages light down to a coarser grid while its rows arrive from the top down, so that the fine
/// grid need not be kept. Each coarse texel is the mean over its extent, weighted by exact solid
/// angles, so the mean radiance stays. Memory: the coarse grid.
class EnvironmentBuilder {
public:
    /// `height` rows of the result, from 1 to `fine_height`.
    EnvironmentBuilder(int fine_height, int height);

    /// The next rows, in order. A texel is `floats_per_texel` floats of which the first three are
    /// its radiance.
    void add_rows(int row_count, const float* texels, int floats_per_texel);

    /// The coarse environment, when every row was added.
    Environment finish() &&;

private:
    void add_row(const float* texels, int floats_per_texel);
    void add_share(const std::vector<Vec3d>& row, double from, double to);

    int fine_height_;
    int next_row_ = 0;
    Environment coarse_;
    std::vector<Vec3d> sums_;  // of the coarse row that is being filled
    double weight_ = 0;
};

}  // namespace splitsum
