#include "splitsum/filter/spectrum.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

#include "splitsum/base/parallel.h"
#include "splitsum/filter/legendre_kernels.h"
#include "splitsum/math/quadrature.h"

namespace splitsum {
namespace {

constexpr double pi = std::numbers::pi;
using Complex = std::complex<double>;

// ∫ e^(-i m phi) dphi over the first texel of a row.
Complex first_texel(int m, int width) {
    const double left = -pi, step = 2 * pi / width;
    const double sinc = m == 0 ? 1 : std::sin(0.5 * m * step) / (0.5 * m * step);
    return std::polar(step * sinc, -m * (left + 0.5 * step));
}

// One more Gauss point than it takes for the highest band to turn by 1.6 radians from one to the
// next: with three, band l is missed by (l height)⁶ / 2e6.
LegendreRows gauss_rows(int height, int bands) {
    const size_t pairs = size_t(height + 1) / 2;
    const double step = pi / height;
    LegendreRows rows;
    rows.rows = padded(pairs);
    rows.points = size_t(std::max(3, int(std::ceil(bands * step / 1.6)) + 2));
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

double square_of_row(const float* texels, int width, int floats_per_texel) {
    double sum = 0;
    for (int x = 0; x < width; ++x, texels += floats_per_texel)
        for (int c = 0; c < 3; ++c) sum += double(texels[c]) * double(texels[c]);
    return sum;
}

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
    for (int m = 0; m < bands_; ++m) {
        const auto coefficients = order(m);
        for (size_t i = 0; i < coefficients.size(); ++i)
            power_[size_t(m) + i / complex_rgb] +=
                (m == 0 ? 1 : 2) * coefficients[i] * coefficients[i];
    }
}

// Two rows, packed as real and imaginary part of one complex signal; the second may be missing.
struct SpectrumBuilder::RowPair {
    int first_row;
    const float* first;
    const float* second;
    int floats_per_texel;
};

SpectrumBuilder::SpectrumBuilder(int height, int bands)
    : height_(height),
      bands_(bands),
      fft_(2 * height, Fft::Direction::forward),
      fourier_(size_t(bands) * complex_rgb * size_t(height)),
      row_power_(size_t(height)) {
    for (int m = 0; m < bands; ++m) first_texel_.push_back(splitsum::first_texel(m, 2 * height));
}

void SpectrumBuilder::add_rows(int first_row, int row_count, const float* texels,
                               int floats_per_texel) {
    const int width = 2 * height_;
    const auto row = [&](int i) {
        return texels + size_t(i) * size_t(width) * size_t(floats_per_texel);
    };
    parallel_rows((row_count + 1) / 2, [&](int pair) {
        const bool two = 2 * pair + 1 < row_count;
        transform({first_row + 2 * pair, row(2 * pair), two ? row(2 * pair + 1) : nullptr,
                   floats_per_texel});
        for (int i = 2 * pair; i < 2 * pair + (two ? 2 : 1); ++i)
            row_power_[size_t(first_row + i)] = square_of_row(row(i), width, floats_per_texel) *
                                                solid_angle_of_row(first_row + i, height_);
    });
}

void SpectrumBuilder::transform(const RowPair& rows) {
    const size_t width = 2 * size_t(height_), height = size_t(height_);
    std::vector<FftValue> packed(width), bins(width);
    for (size_t channel = 0; channel < 3; ++channel) {
        for (size_t x = 0; x < width; ++x) {
            const size_t at = x * size_t(rows.floats_per_texel) + channel;
            packed[x] = {rows.first[at], rows.second ? rows.second[at] : 0.0f};
        }
        fft_.transform(packed, bins);
        for (int m = 0; m < bands_; ++m) {
            const size_t bin = size_t(m) % width;
            const FftValue z = bins[bin], w = bins[(width - bin) % width];
            const Complex texel = first_texel_[size_t(m)];
            const Complex first = texel * Complex(0.5 * (z.r + w.r), 0.5 * (z.i - w.i));
            float* real = row_values(m) + channel * height + size_t(rows.first_row);
            float* imaginary = real + 3 * height;
            real[0] = float(first.real());
            imaginary[0] = float(first.imag());
            if (!rows.second) continue;
            const Complex second = texel * Complex(0.5 * (z.i + w.i), 0.5 * (w.r - z.r));
            real[1] = float(second.real());
            imaginary[1] = float(second.imag());
        }
    }
}

Spectrum SpectrumBuilder::finish() const {
    const LegendreRows rows = gauss_rows(height_, bands_);
    Spectrum spectrum(bands_);
    parallel_rows(bands_, [&](int m) {
        const FoldedRows folded(row_values(m), height_, rows.rows);
        const size_t first = first_relevant_angle(m, bands_, {rows.sine.data(), rows.rows});
        integrate_order(LegendreOrder(m, bands_), bands_, rows, first, folded.even.data(),
                        folded.odd.data(), spectrum.order(m).data());
    });
    spectrum.measure_power(std::accumulate(row_power_.begin(), row_power_.end(), 0.0));
    return spectrum;
}

Spectrum forward_transform(const Environment& environment, int bands) {
    SpectrumBuilder builder(environment.height(), bands);
    builder.add_rows(0, environment.height(), environment.texels().data(), 4);
    return builder.finish();
}

double integral_of_square(const Environment& environment) {
    return ordered_sum(environment.height(), [&](int y) {
        const float* row =
            environment.texels().data() + 4 * size_t(y) * size_t(environment.width());
        return square_of_row(row, environment.width(), 4) *
               solid_angle_of_row(y, environment.height());
    });
}

}  // namespace splitsum
