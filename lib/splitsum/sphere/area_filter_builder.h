#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "splitsum/math/vec.h"
#include "splitsum/sphere/area_edges_detail.h"
#include "splitsum/sphere/area_geometry.h"
#include "splitsum/sphere/cubemap.h"

namespace splitsum {

/// The mirror image (area_filter.h) of a panorama whose rows arrive from the top down.
///
/// When a row passes by, with the sums of the columns above it at hand, F is known for every node
/// in that row and is added to the node's edge. Nothing is kept of the row.
///
/// Memory: 168 bytes for each texel of one face, half a megabyte or five rows of sums (24 bytes a
/// texel), and the geometry. In all, for 16384 x 8192 texels: 34 MB for faces of 256 texels, 94 MB
/// for 512.
class AreaFilterBuilder {
public:
    explicit AreaFilterBuilder(std::shared_ptr<const AreaGeometry> geometry);

    /// With a geometry of its own.
    AreaFilterBuilder(int height, int face_size, const Mat3d& panorama_from_cube);

    /// The next rows, in order. A texel is `floats_per_texel` floats of which the first three are
    /// its radiance. Bands of any size give the same bits; a few dozen rows at once are faster than
    /// one.
    void add_rows(int row_count, const float* texels, int floats_per_texel);

    /// The cubemap, when every row was added.
    Cubemap finish() &&;

private:
    // Sums over the rows above one row, for each column of a quarter.
    using ColumnSums = std::vector<FourTurns>;

    void add_block(int row_count, const float* columns, int floats_per_column);
    void sum_columns(int row_count, const float* columns, int floats_per_column);
    void sum_row(int row, int first, int last, const float* columns, int floats_per_column);
    void add_nodes(int row_count);

    std::shared_ptr<const AreaGeometry> geometry_;
    Cubemap cubemap_;
    AreaEdges edges_;
    std::vector<std::array<uint32_t, 2>> runs_done_;  // [line][arc], of the half being filled
    std::vector<ColumnSums> above_;                   // of a block of rows, and of the one after it
    int next_row_ = 0;
};

}  // namespace splitsum
