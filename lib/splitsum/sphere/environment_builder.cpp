#include "splitsum/sphere/environment_builder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/base/parallel.h"
#include "splitsum/sphere/lat_long_average_detail.h"

namespace splitsum {
EnvironmentBuilder::EnvironmentBuilder(int fine_height, int height)
    : fine_height_(fine_height), coarse_(height), sums_(size_t(2 * height), Vec3d(0)) {}

void EnvironmentBuilder::add_rows(int row_count, const float* texels, int floats_per_texel) {
    std::vector<Share> shares;
    for (int row = 0; row < row_count; ++row) append_shares(row, shares);
    constexpr int block = 32;  // coarse texels that one thread takes
    const int count = coarse_.width();
    parallel_rows((count + block - 1) / block, [&](int b) {
        const int first = b * block, end = std::min(count, first + block);
        add_columns(first, end, shares, texels, floats_per_texel);
    });
    next_row_ += row_count;
}

void EnvironmentBuilder::append_shares(int row, std::vector<Share>& shares) {
    const double from = double(next_row_ + row) / fine_height_;
    const double to = double(next_row_ + row + 1) / fine_height_;
    // The coarse rows' edges that lie inside the fine row cut it.
    double start = from;
    for (int edge = int(from * coarse_.height()) + 1; start < to; ++edge) {
        const double end = std::min(to, double(edge) / coarse_.height());
        // A sliver is rounding: its row is complete already.
        if ((end - start) * coarse_.height() > 1e-9) shares.push_back(share(row, start, end));
        start = std::max(start, end);
    }
}

EnvironmentBuilder::Share EnvironmentBuilder::share(int row, double from, double to) {
    Share share{row, zone_height(from, to)};
    weight_ += share.weight;
    const int y = std::min(int(0.5 * (from + to) * coarse_.height()), coarse_.height() - 1);
    if (to * coarse_.height() < y + 1 - 1e-9) return share;
    share.completes = y;
    share.whole = weight_;
    weight_ = 0;
    return share;
}

void EnvironmentBuilder::add_columns(int first, int end, const std::vector<Share>& shares,
                                     const float* texels, int floats_per_texel) {
    const int width = 2 * fine_height_;
    const double ratio = double(width) / coarse_.width();
    for (const Share& share : shares) {
        const float* row = texels + size_t(share.row) * size_t(width) * size_t(floats_per_texel);
        for (int i = first; i < end; ++i) {
            Vec3d& sum = sums_[size_t(i)];
            sum += share.weight *
                   mean_over_arc(row, width, floats_per_texel, i * ratio, (i + 1) * ratio);
            if (share.completes < 0) continue;
            coarse_.set_texel(i, share.completes, Vec3(sum / share.whole));
            sum = Vec3d(0);
        }
    }
}

Environment EnvironmentBuilder::finish() && { return std::move(coarse_); }

}  // namespace splitsum
