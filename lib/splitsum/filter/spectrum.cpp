#include "splitsum/filter/spectrum.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "splitsum/base/parallel.h"
#include "splitsum/filter/fft.h"
#include "splitsum/filter/legendre_kernels.h"
#include "splitsum/math/quadrature.h"

namespace splitsum {
namespace {

constexpr double pi = std::numbers::pi;
using Complex = std::complex<double>;

// [order][even, odd][complex_rgb][row] floats: for each order, the Fourier coefficient of each
// northern row plus (even) or minus (odd) that of its southern mirror.
struct RowFourier {
    size_t rows;  // padded
    std::vector<float> values;

    RowFourier(size_t padded_rows, int orders)
        : rows(padded_rows), values(size_t(orders) * 2 * complex_rgb * padded_rows) {}

    float* even(int m) { return values.data() + size_t(m) * 2 * complex_rgb * rows; }
    float* odd(int m) { return even(m) + complex_rgb * rows; }
};

// ∫ e^(-i m phi) dphi over the first texel of a row.
Complex first_texel(int m, int width) {
    const double left = -pi, step = 2 * pi / width;
    const double sinc = m == 0 ? 1 : std::sin(0.5 * m * step) / (0.5 * m * step);
    return std::polar(step * sinc, -m * (left + 0.5 * step));
}

// Row y and its mirror image, packed as real and imaginary part of one complex signal.
void pack_rows(const Environment& environment, int y, int channel, std::span<FftValue> packed) {
    const int mirror = environment.height() - 1 - y;
    for (int x = 0; x < environment.width(); ++x)
        packed[size_t(x)] = {environment.texel(x, y)[channel],
                             mirror == y ? 0.0f : environment.texel(x, mirror)[channel]};
}

void transform_row_pair(const Environment& environment, int y, const std::vector<Complex>& texel,
                        const Fft& fft, RowFourier& fourier) {
    const size_t width = size_t(environment.width());
    std::vector<FftValue> packed(width), bins(width);
    for (int channel = 0; channel < 3; ++channel) {
        pack_rows(environment, y, channel, packed);
        fft.transform(packed, bins);
        for (int m = 0; m < std::ssize(texel); ++m) {
            const size_t bin = size_t(m) % width;
            const FftValue z = bins[bin], w = bins[(width - bin) % width];
            const Complex north(0.5 * (z.r + w.r), 0.5 * (z.i - w.i));
            const Complex south(0.5 * (z.i + w.i), 0.5 * (w.r - z.r));
            const Complex even = texel[size_t(m)] * (north + south);
            const Complex odd = texel[size_t(m)] * (north - south);
            const size_t real = size_t(channel) * fourier.rows + size_t(y);
            const size_t imaginary = real + 3 * fourier.rows;
            fourier.even(m)[real] = float(even.real());
            fourier.even(m)[imaginary] = float(even.imag());
            fourier.odd(m)[real] = float(odd.real());
            fourier.odd(m)[imaginary] = float(odd.imag());
        }
    }
}

RowFourier fourier_of_rows(const Environment& environment, int orders) {
    const int pairs = (environment.height() + 1) / 2;
    RowFourier fourier(padded(size_t(pairs)), orders);
    std::vector<Complex> texel;
    for (int m = 0; m < orders; ++m) texel.push_back(first_texel(m, environment.width()));
    const Fft fft(environment.width(), Fft::Direction::forward);
    parallel_rows(pairs,
                  [&](int y) { transform_row_pair(environment, y, texel, fft, fourier); });
    return fourier;
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

double integral_of_square(const Environment& environment) {
    return ordered_sum(environment.height(), [&](int y) {
        double sum = 0;
        for (int x = 0; x < environment.width(); ++x) {
            const Vec3d radiance(environment.texel(x, y));
            sum += dot(radiance, radiance);
        }
        return sum * solid_angle_of_row(y, environment.height());
    });
}

Spectrum forward_transform(const Environment& environment, int bands) {
    RowFourier fourier = fourier_of_rows(environment, bands);
    const LegendreRows rows = gauss_rows(environment.height(), bands);
    Spectrum spectrum(bands);
    parallel_rows(bands, [&](int m) {
        const LegendreOrder order(m, bands);
        const size_t first = first_relevant_angle(m, bands, {rows.sine.data(), rows.rows});
        integrate_order(order, bands, rows, first, fourier.even(m), fourier.odd(m),
                        spectrum.order(m).data());
    });
    spectrum.measure_power(integral_of_square(environment));
    return spectrum;
}

}  // namespace splitsum
