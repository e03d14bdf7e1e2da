#include "splitsum/filter/line_fourier.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/base/parallel.h"

namespace splitsum {
namespace {

constexpr double pi = std::numbers::pi;

// ∫ e^(-i m phi) dphi over the first texel of a line.
std::complex<float> first_texel(int m, int width) {
    const double left = -pi, step = 2 * pi / width;
    const double sinc = m == 0 ? 1 : std::sin(0.5 * m * step) / (0.5 * m * step);
    return std::complex<float>(std::polar(step * std::abs(sinc), -m * (left + 0.5 * step)) *
                               (sinc < 0 ? -1.0 : 1.0));
}

}  // namespace

// One channel of a few lines, which end up side by side in memory. Two lines are packed as the real
// and imaginary part of one complex signal; the last may be missing.
struct LineFourier::Block {
    static constexpr size_t most_lines = 8;

    size_t first_line;
    std::span<const float* const> lines;
    size_t floats_per_texel;
    size_t channel;
};

LineFourier::LineFourier(int lines, int width, int orders)
    : lines_(size_t(lines)),
      width_(width),
      orders_(orders),
      fft_(width, Fft::Direction::forward),
      coefficients_(size_t(orders) * 6 * lines_) {
    for (int m = 0; m < orders; ++m) first_texel_.push_back(first_texel(m, width));
}

void LineFourier::add(int first_line, std::span<const float* const> lines, int floats_per_texel) {
    const size_t blocks = (lines.size() + Block::most_lines - 1) / Block::most_lines;
    parallel_rows(int(3 * blocks), [&](int task) {
        const size_t first = size_t(task) / 3 * Block::most_lines;
        const size_t count = std::min(Block::most_lines, lines.size() - first);
        transform({size_t(first_line) + first, lines.subspan(first, count),
                   size_t(floats_per_texel), size_t(task) % 3});
    });
}

void LineFourier::transform(const Block& block) {
    const size_t width = size_t(width_), count = block.lines.size();
    const size_t pairs = (count + 1) / 2;
    std::vector<FftValue> packed(width), bins(pairs * width);
    for (size_t pair = 0; pair < pairs; ++pair) {
        const float* first = block.lines[2 * pair] + block.channel;
        const bool two = 2 * pair + 1 < count;
        const float* second = two ? block.lines[2 * pair + 1] + block.channel : nullptr;
        for (size_t x = 0; x < width; ++x) {
            const size_t at = x * block.floats_per_texel;
            packed[x] = {first[at], two ? second[at] : 0.0f};
        }
        fft_.transform(packed, std::span(bins).subspan(pair * width, width));
    }
    for (int m = 0; m < orders_; ++m) {
        const size_t bin = size_t(m) % width, mirror = (width - bin) % width;
        const float tr = 0.5f * first_texel_[size_t(m)].real();
        const float ti = 0.5f * first_texel_[size_t(m)].imag();
        float* real =
            coefficients_.data() + index_of(m) + block.channel * lines_ + block.first_line;
        float* imaginary = real + 3 * lines_;
        for (size_t pair = 0; pair < pairs; ++pair) {
            const FftValue z = bins[pair * width + bin], w = bins[pair * width + mirror];
            const FftValue first{z.r + w.r, z.i - w.i}, second{z.i + w.i, w.r - z.r};
            real[2 * pair] = tr * first.r - ti * first.i;
            imaginary[2 * pair] = tr * first.i + ti * first.r;
            if (2 * pair + 1 == count) break;
            real[2 * pair + 1] = tr * second.r - ti * second.i;
            imaginary[2 * pair + 1] = tr * second.i + ti * second.r;
        }
    }
}

}  // namespace splitsum
