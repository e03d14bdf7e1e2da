#pragma once

#include <complex>
#include <span>
#include <vector>

#include "splitsum/base/buffer.h"
#include "splitsum/filter/fft.h"

namespace splitsum {

/// The Fourier coefficients of an environment along its lines of equal polar angle: of piecewise-
/// constant light, exact over each texel's azimuths (an FFT, then the closed form of one texel's
/// transform),
///     F_m = ∫ L e^(-i m phi) dphi,   0 <= m < orders.
/// fp32: errors of about 1e-7 of the line's largest coefficient, white over the orders.
/// Memory: 24 bytes a line and order.
class LineFourier {
public:
    /// `width` texels a line; `orders` may exceed it.
    LineFourier(int lines, int width, int orders);

    /// Transforms lines, in parallel, two by two from `first_line` on. A texel is `floats_per_texel` floats of which the first three
    /// are its radiance.
    void add(int first_line, std::span<const float* const> lines, int floats_per_texel);

    /// Order m: real parts of red, green and blue, then imaginary parts, each for every line.
    const float* order(int m) const { return coefficients_.data() + index_of(m); }

private:
    struct Block;
    void transform(const Block& block);
    size_t index_of(int m) const { return size_t(m) * 6 * lines_; }

    size_t lines_;
    int width_;
    int orders_;
    Fft fft_;
    std::vector<std::complex<float>> first_texel_;  // its transform, for each order
    Buffer<float> coefficients_;
};

}  // namespace splitsum
