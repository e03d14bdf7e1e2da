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
    // The part of a fine row that lies in one coarse row.
    struct Share {
        int row;  // among those that are being added
        double weight;
        int completes = -1;  // the coarse row of which this is the last part
        double whole = 0;    // the weight of that row
    };

    void append_shares(int row, std::vector<Share>& shares);
    Share share(int row, double from, double to);
    void add_columns(int first, int end, const std::vector<Share>& shares, const float* texels,
                     int floats_per_texel);

    int fine_height_;
    int next_row_ = 0;
    Environment coarse_;
    std::vector<Vec3d> sums_;  // of the coarse row that is being filled
    double weight_ = 0;        // of its parts so far
};

}  // namespace splitsum
