#include "splitsum/sphere/area_filter_builder.h"

#include <algorithm>
#include <cassert>

#include "splitsum/base/parallel.h"
#include "splitsum/sphere/area_kernels.h"
#include "splitsum/sphere/lat_long_average_detail.h"

namespace splitsum {
namespace {

// As many rows as fit in a processor's own cache, within reason.
size_t rows_of_block(const AreaGeometry& geometry) {
    constexpr size_t cache = 1 << 19;
    const size_t row = size_t(geometry.columns_per_quarter()) * sizeof(FourTurns);
    return std::clamp<size_t>(cache / row, 4, 64);
}

// Rows in which each texel is repeated for each of its columns.
std::vector<float> cut_into_columns(const float* texels, size_t count, int floats_per_texel,
                                    int parts) {
    std::vector<float> columns;
    columns.reserve(3 * count * size_t(parts));
    for (size_t i = 0; i < count; ++i, texels += floats_per_texel)
        for (int part = 0; part < parts; ++part) columns.insert(columns.end(), texels, texels + 3);
    return columns;
}

}  // namespace

AreaFilterBuilder::AreaFilterBuilder(std::shared_ptr<const AreaGeometry> geometry)
    : geometry_(std::move(geometry)),
      cubemap_(geometry_->face_size()),
      edges_(geometry_->face_size()),
      runs_done_(geometry_->lines().size()),
      above_(rows_of_block(*geometry_) + 1, ColumnSums(size_t(geometry_->columns_per_quarter()))) {}

AreaFilterBuilder::AreaFilterBuilder(int height, int face_size, const Mat3d& panorama_from_cube)
    : AreaFilterBuilder(
          std::make_shared<const AreaGeometry>(height, face_size, panorama_from_cube)) {}

void AreaFilterBuilder::add_rows(int row_count, const float* texels, int floats_per_texel) {
    assert(next_row_ + row_count <= geometry_->height());
    const size_t width = 2 * size_t(geometry_->height());
    const int most = int(above_.size()) - 1;
    for (int row = 0; row < row_count; row += most) {
        const int count = std::min(most, row_count - row);
        const float* first = texels + size_t(row) * width * size_t(floats_per_texel);
        if (geometry_->parts() == 1)
            add_block(count, first, floats_per_texel);
        else
            add_block(
                count,
                cut_into_columns(first, size_t(count) * width, floats_per_texel, geometry_->parts())
                    .data(),
                3);
    }
}

void AreaFilterBuilder::add_block(int row_count, const float* columns, int floats_per_column) {
    sum_columns(row_count, columns, floats_per_column);
    const int height = geometry_->height(), end = next_row_ + row_count;
    if (!edges_.lower) add_nodes(row_count);
    if (!edges_.lower && 2 * end >= height) {
        fill_upper_half(*geometry_, edges_, cubemap_);
        edges_.start_lower_half();
        std::ranges::fill(runs_done_, std::array<uint32_t, 2>{});
    }
    if (edges_.lower) add_nodes(row_count);
    std::swap(above_.front(), above_[size_t(row_count)]);
    next_row_ = end;
}

// In stripes, so that a few rows of one stay in the processor's cache.
void AreaFilterBuilder::sum_columns(int row_count, const float* columns, int floats_per_column) {
    constexpr int stripe = 64;
    const int quarter = geometry_->columns_per_quarter();
    // Where, in one of the turns, the right edge of the panorama is passed.
    const int seam = (4 * quarter - geometry_->first_column()) % quarter;
    parallel_rows((quarter + stripe - 1) / stripe, [&](int i) {
        const int first = i * stripe, last = std::min(quarter, first + stripe);
        const int middle = std::clamp(seam, first, last);
        for (int row = 0; row < row_count; ++row) {
            const float* row_columns =
                columns + 4 * size_t(row) * size_t(quarter) * size_t(floats_per_column);
            sum_row(row, first, middle, row_columns, floats_per_column);
            sum_row(row, middle, last, row_columns, floats_per_column);
        }
    });
}

// The columns from `first` up to `last` of each quarter, with no seam between them.
void AreaFilterBuilder::sum_row(int row, int first, int last, const float* columns,
                                int floats_per_column) {
    const int quarter = geometry_->columns_per_quarter();
    std::array<const float*, 4> four;
    for (int turn = 0; turn < 4; ++turn) {
        const int at = (geometry_->first_column() + turn * quarter + first) % (4 * quarter);
        const int column = geometry_->mirrored() ? 4 * quarter - 1 - at : at;
        four[size_t(turn)] = columns + size_t(column) * size_t(floats_per_column);
    }
    const double v = next_row_ + row, height = geometry_->height();
    add_row(&above_[size_t(row)][size_t(first)], &above_[size_t(row) + 1][size_t(first)],
            size_t(last - first), four,
            geometry_->mirrored() ? -floats_per_column : floats_per_column,
            zone_height(v / height, (v + 1) / height));
}

void AreaFilterBuilder::add_nodes(int row_count) {
    std::vector<const FourTurns*> above;
    for (const ColumnSums& row : above_) above.push_back(row.data());
    const AreaRows rows{above.data(), next_row_, row_count, geometry_->height(), edges_.lower};
    parallel_rows(int(runs_done_.size()), [&](int line) {
        for (size_t arc = 0; arc < 2; ++arc) {
            uint32_t& done = runs_done_[size_t(line)][arc];
            done = add_runs(geometry_->lines()[size_t(line)].arcs[arc], arc == 0 ? -1 : 1, done,
                            rows, edges_.line(line));
        }
    });
}

Cubemap AreaFilterBuilder::finish() && {
    assert(next_row_ == geometry_->height());
    fill_lower_half(*geometry_, edges_, above_.front(), cubemap_);
    return std::move(cubemap_);
}

}  // namespace splitsum
