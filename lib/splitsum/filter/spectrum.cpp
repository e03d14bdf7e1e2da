#include "splitsum/filter/spectrum.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "splitsum/base/parallel.h"
#include "splitsum/filter/legendre_kernels.h"
#include "splitsum/filter/line_kernels.h"
#include "splitsum/math/quadrature.h"

namespace splitsum {
namespace {

constexpr double pi = std::numbers::pi;

// Rings that stand for the rows of a large panorama, three a band or as many as half the rows;
// nothing where these are too few to be as good as the rows.
std::optional<int> rings_for(int height, int bands) {
    const int rings = std::max(std::min(3 * bands, height / 2), 64);
    return 4 * rings >= 9 * bands && 2 * rings <= height ? std::optional(rings) : std::nullopt;
}

// One more Gauss point than it takes for the highest band to turn by 1.6 radians from one to the
// next; three do up to 2 radians a row: band l is missed by (l step)⁶ / 2e6.
LegendreRows gauss_rows(int height, int bands) {
    const size_t pairs = size_t(height + 1) / 2;
    const double step = pi / height;
    LegendreRows rows;
    rows.rows = padded(pairs);
    rows.points = bands * step <= 2 ? 3 : size_t(std::ceil(bands * step / 1.6)) + 2;
    const QuadratureRule rule = gauss_legendre(int(rows.points));
    const size_t size = rows.rows * rows.points;
    rows.cosine.assign(size, 0);
    rows.sine.assign(size, 0);
    rows.weight.assign(size, 0);
    for (size_t point = 0; point < rows.points; ++point)
        for (size_t y = 0; y < pairs; ++y) {
            const double theta = (double(y) + 0.5 + 0.5 * rule.nodes[point]) * step;
            const size_t i = point * rows.rows + y;
            rows.cosine[i] = std::cos(theta);
            rows.sine[i] = std::sin(theta);
            rows.weight[i] = 0.5 * step * rule.weights[point] * rows.sine[i];
        }
    return rows;
}

// Of each row, the sine of its Gauss point nearest the equator: a row of a panorama that has few may
// begin at the pole and yet hold the equator.
std::vector<double> largest_sines(const LegendreRows& rows) {
    std::vector<double> largest(rows.rows);
    for (size_t i = 0; i < rows.sine.size(); ++i)
        largest[i % rows.rows] = std::max(largest[i % rows.rows], rows.sine[i]);
    return largest;
}

// Rings at which the polar angle is integrated already.
LegendreRows ring_points(int rings) {
    const size_t pairs = size_t(rings + 1) / 2;
    LegendreRows rows;
    rows.rows = padded(pairs);
    rows.points = 1;
    rows.cosine.assign(rows.rows, 0);
    rows.sine.assign(rows.rows, 0);
    rows.weight.assign(rows.rows, 0);
    for (size_t k = 0; k < pairs; ++k) {
        const double theta = pi * (double(k) + 0.5) / rings;
        rows.cosine[k] = std::cos(theta);
        rows.sine[k] = std::sin(theta);
        rows.weight[k] = 1;
    }
    return rows;
}

// The sum of a northern row and its southern mirror, and their difference, for one order.
struct FoldedRows {
    std::vector<float> even, odd;  // [complex_rgb][padded pairs]

    FoldedRows(const float* rows, int height, size_t padded_pairs)
        : even(complex_rgb * padded_pairs), odd(complex_rgb * padded_pairs) {
        for (size_t c = 0; c < complex_rgb; ++c)
            for (int y = 0; y < (height + 1) / 2; ++y) {
                const int mirror = height - 1 - y;
                const float north = rows[c * size_t(height) + size_t(y)];
                const float south = mirror == y ? 0 : rows[c * size_t(height) + size_t(mirror)];
                even[c * padded_pairs + size_t(y)] = north + south;
                odd[c * padded_pairs + size_t(y)] = north - south;
            }
    }
};

}  // namespace

Spectrum::Spectrum(int bands)
    : bands_(bands),
      coefficients_(complex_rgb * size_t(bands) * size_t(bands + 1) / 2),
      power_(size_t(bands)) {}

std::span<double> Spectrum::order(int m) {
    // Orders 0 .. m - 1 hold bands, bands - 1, ... coefficients.
    const size_t before = size_t(m) * size_t(2 * bands_ - m + 1) / 2;
    return {coefficients_.data() + complex_rgb * before, complex_rgb * size_t(bands_ - m)};
}

std::span<const double> Spectrum::order(int m) const {
    return const_cast<Spectrum*>(this)->order(m);
}

void Spectrum::measure_power(double total_power) {
    total_power_ = total_power;
    parallel_rows(bands_, [&](int l) {
        double power = 0;
        for (int m = 0; m <= l; ++m)
            for (const double part : order(m).subspan(complex_rgb * size_t(l - m), complex_rgb))
                power += (m == 0 ? 1 : 2) * part * part;
        power_[size_t(l)] = power;
    });
}

SpectrumBuilder::SpectrumBuilder(int height, int bands)
    : height_(height),
      bands_(bands),
      lines_(rings_for(height, bands).value_or(height)),
      fourier_(lines_, 2 * height, bands),
      row_power_(size_t(height)) {
    if (lines_ < height) rings_.emplace(height, lines_);
}

void SpectrumBuilder::add_rows(int row_count, const float* texels, int floats_per_texel) {
    const size_t row_floats = 2 * size_t(height_) * size_t(floats_per_texel);
    std::vector<const float*> rows;
    for (int i = 0; i < row_count; ++i) rows.push_back(texels + size_t(i) * row_floats);
    parallel_rows(row_count, [&](int i) {
        const int row = next_row_ + i;
        row_power_[size_t(row)] =
            sum_of_squares(rows[size_t(i)], row_floats) * solid_angle_of_row(row, height_);
    });
    if (rings_)
        rings_->add_rows(row_count, texels, floats_per_texel,
                         [&](int first_ring, std::span<const float* const> rings) {
                             fourier_.add(first_ring, rings, floats_per_texel);
                         });
    else
        fourier_.add(next_row_, rows, floats_per_texel);
    next_row_ += row_count;
}

Spectrum SpectrumBuilder::finish() const {
    const LegendreRows rows = rings_ ? ring_points(lines_) : gauss_rows(height_, bands_);
    const std::vector<double> sines = largest_sines(rows);
    Spectrum spectrum(bands_);
    parallel_rows(bands_, [&](int m) {
        const FoldedRows folded(fourier_.order(m), lines_, rows.rows);
        const size_t first = first_relevant_angle(m, bands_, sines);
        integrate_order(LegendreOrder(m, bands_), bands_, rows, first, folded.even.data(),
                        folded.odd.data(), spectrum.order(m).data());
    });
    spectrum.measure_power(std::accumulate(row_power_.begin(), row_power_.end(), 0.0));
    return spectrum;
}

Spectrum forward_transform(const Environment& environment, int bands) {
    SpectrumBuilder builder(environment.height(), bands);
    builder.add_rows(environment.height(), environment.texels().data(), 4);
    return builder.finish();
}

double integral_of_square(const Environment& environment) {
    return ordered_sum(environment.height(), [&](int y) {
        const size_t row_floats = 4 * size_t(environment.width());
        return sum_of_squares(environment.texels().data() + size_t(y) * row_floats, row_floats) *
               solid_angle_of_row(y, environment.height());
    });
}

}  // namespace splitsum
