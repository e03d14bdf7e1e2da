#include "splitsum/filter/rows_to_rings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/base/parallel.h"
#include "splitsum/filter/line_kernels.h"
#include "splitsum/math/quadrature.h"

namespace splitsum {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int band_rows = 64;         // that are gathered at a time
constexpr size_t chunk_texels = 256;  // of a row: nine rings of them fit a first-level cache
constexpr int points = 8;             // of the polynomial

// Lagrange's polynomial through the points -3 .. 4 at t in [0, 1]: the weight of each point.
std::array<double, points> lagrange_weights(double t) {
    std::array<double, points> weights;
    for (int i = 0; i < points; ++i) {
        double weight = 1;
        for (int j = 0; j < points; ++j)
            if (j != i) weight *= (t + 3 - j) / (i - j);
        weights[size_t(i)] = weight;
    }
    return weights;
}

}  // namespace

RowsToRings::RowsToRings(int height, int rings)
    : height_(height), rings_(rings), slots_(band_rows * rings / height + 2 * taps + 2) {
    for (int row = 0; row < height; ++row) rows_.push_back(taps_of(row));
}

RowsToRings::RowTaps RowsToRings::taps_of(int row) const {
    const auto interval_of = [&](double theta) {  // the ring above
        return int(std::floor(theta / pi * rings_ - 0.5));
    };
    const double step = pi / height_;
    RowTaps row_taps;
    row_taps.first_ring = interval_of(row * step) - 3;
    const QuadratureRule rule = gauss_legendre(4);
    std::array<double, taps> sums{};
    for (size_t i = 0; i < rule.nodes.size(); ++i) {
        const double theta = (row + 0.5 + 0.5 * rule.nodes[i]) * step;
        const int interval = interval_of(theta);
        const auto weights = lagrange_weights(theta / pi * rings_ - 0.5 - interval);
        for (int k = 0; k < points; ++k)
            sums[size_t(interval - 3 + k - row_taps.first_ring)] +=
                0.5 * step * rule.weights[i] * std::sin(theta) * weights[size_t(k)];
    }
    std::ranges::copy(sums, row_taps.weight.begin());
    return row_taps;
}

void RowsToRings::add_rows(int row_count, const float* texels, int floats_per_texel,
                           const CompleteRings& complete) {
    line_floats_ = 2 * size_t(height_) * size_t(floats_per_texel);
    window_.resize(size_t(slots_) * line_floats_);
    for (int row = 0; row < row_count; row += band_rows)
        add_band(std::min(band_rows, row_count - row), texels + size_t(row) * line_floats_,
                 complete);
}

void RowsToRings::add_band(int row_count, const float* texels, const CompleteRings& complete) {
    const size_t half = line_floats_ / 2;
    const size_t chunk = chunk_texels * (line_floats_ / (2 * size_t(height_)));
    // Both halves of the circle together: beyond a pole one writes to the other.
    parallel_rows(int((half + chunk - 1) / chunk), [&](int i) {
        const size_t first = size_t(i) * chunk, count = std::min(chunk, half - first);
        for (int row = 0; row < row_count; ++row)
            for (const size_t column : {first, first + half})
                add_columns(next_row_ + row, texels + size_t(row) * line_floats_, column, count);
    });
    next_row_ += row_count;
    // The last rings get light from beyond the pole until the end.
    const bool all = next_row_ == height_;
    const int end = all ? rings_ : std::min(rows_[size_t(next_row_)].first_ring, rings_ - taps);
    hand_out(all ? end : end - end % 2, complete);
}

void RowsToRings::add_columns(int row, const float* texels, size_t first, size_t count) {
    const RowTaps& row_taps = rows_[size_t(row)];
    std::array<float*, taps> lines;
    for (int k = 0; k < taps; ++k) {
        const int ring = row_taps.first_ring + k;
        const bool beyond = ring < 0 || ring >= rings_;
        const int inside = ring < 0 ? -1 - ring : beyond ? 2 * rings_ - 1 - ring : ring;
        const size_t column = beyond ? (first + line_floats_ / 2) % line_floats_ : first;
        lines[size_t(k)] = slot(inside) + column;
    }
    add_to_lines(texels + first, count, row_taps.weight, lines);
}

void RowsToRings::hand_out(int end, const CompleteRings& complete) {
    if (end <= next_ring_) return;
    std::vector<const float*> lines;
    for (int ring = next_ring_; ring < end; ++ring) lines.push_back(slot(ring));
    complete(next_ring_, lines);
    for (; next_ring_ < end; ++next_ring_) std::fill_n(slot(next_ring_), line_floats_, 0.0f);
}

}  // namespace splitsum
