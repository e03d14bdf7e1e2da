#include "splitsum/sphere/environment_builder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/base/parallel.h"
#include "splitsum/sphere/lat_long_average_detail.h"

namespace splitsum {
namespace {

// The mean of a fine row over each of `sums.size()` equal arcs.
void average_along(const float* texels, int width, int floats_per_texel, std::vector<Vec3d>& sums) {
    const double ratio = double(width) / double(sums.size());
    constexpr int block = 128;  // coarse texels that one thread takes
    const int count = int(sums.size());
    parallel_rows((count + block - 1) / block, [&](int b) {
        for (int i = b * block; i < std::min(count, (b + 1) * block); ++i) {
            sums[size_t(i)] =
                mean_over_arc(texels, width, floats_per_texel, i * ratio, (i + 1) * ratio);
        }
    });
}

}  // namespace

EnvironmentBuilder::EnvironmentBuilder(int fine_height, int height)
    : fine_height_(fine_height), coarse_(height), sums_(size_t(2 * height), Vec3d(0)) {}

void EnvironmentBuilder::add_rows(int row_count, const float* texels, int floats_per_texel) {
    for (int i = 0; i < row_count; ++i)
        add_row(texels + 2 * size_t(fine_height_) * size_t(i) * size_t(floats_per_texel),
                floats_per_texel);
}

void EnvironmentBuilder::add_row(const float* texels, int floats_per_texel) {
    std::vector<Vec3d> row(sums_.size());
    average_along(texels, 2 * fine_height_, floats_per_texel, row);
    const double from = double(next_row_) / fine_height_;
    const double to = double(next_row_ + 1) / fine_height_;
    // The coarse rows' edges that lie inside the fine row cut it.
    double start = from;
    for (int edge = int(from * coarse_.height()) + 1; start < to; ++edge) {
        const double end = std::min(to, double(edge) / coarse_.height());
        // A sliver is rounding: its row is complete already.
        if ((end - start) * coarse_.height() > 1e-9) add_share(row, start, end);
        start = std::max(start, end);
    }
    ++next_row_;
}

void EnvironmentBuilder::add_share(const std::vector<Vec3d>& row, double from, double to) {
    const double weight = zone_height(from, to);
    for (size_t i = 0; i < row.size(); ++i) sums_[i] += weight * row[i];
    weight_ += weight;
    const int y = std::min(int(0.5 * (from + to) * coarse_.height()), coarse_.height() - 1);
    if (to * coarse_.height() < y + 1 - 1e-9) return;
    for (size_t i = 0; i < row.size(); ++i) coarse_.set_texel(int(i), y, Vec3(sums_[i] / weight_));
    std::ranges::fill(sums_, Vec3d(0));
    weight_ = 0;
}

Environment EnvironmentBuilder::finish() && { return std::move(coarse_); }

}  // namespace splitsum
