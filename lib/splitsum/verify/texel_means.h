#pragma once

#include <cstdint>
#include <vector>

#include "splitsum/math/vec.h"

namespace splitsum {

/// A part of the sphere: texel (x, y) of a cube face.
struct CubeTexel {
    int face_size;
    int face, x, y;
};

/// The means of an environment over texels of a cube, what a mirror image should be: the radiance
/// at 128² Hammersley points a texel, each weighted by its solid angle, added row by row of the environment
/// so that rows need not be kept. Shares nothing with the area filter (sphere/area_filter.h).
///
/// Accuracy: that of the points, about 1e-3 of the radiance where the environment's texels are as
/// large as the cube's. Cost: 1 ms and 200 KB a texel.
class TexelMeans {
public:
    /// Of an environment of `height` rows; `panorama_from_cube` takes cube directions to its own.
    TexelMeans(int height, const Mat3d& panorama_from_cube, const std::vector<CubeTexel>& texels);

    /// The next rows, from the top down; of the floats of a texel (3 or 4) the first three are its
    /// radiance. The bits do not depend on how many rows come at a time.
    void add_rows(int row_count, const float* texels, int floats_per_texel);

    /// The means, when every row was added.
    std::vector<Vec3> finish() const;

private:
    struct Point {
        int row;
        int column;
        double weight;
    };
    struct Mean {
        std::vector<Point> points;  // by rows
        size_t done = 0;            // of the points
        double total = 0;           // weight of all points
        Vec3d sum{0};
    };

    std::vector<Point> points_of(const CubeTexel& texel, const Mat3d& panorama_from_cube) const;

    int height_;
    int next_row_ = 0;
    std::vector<Mean> means_;
};

}  // namespace splitsum
