#include "splitsum/filter/line_fourier.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "splitsum/filter/line_kernels.h"

namespace splitsum {
namespace {

constexpr double pi = std::numbers::pi;

// Lines without symmetry; one texel of the first is a sun.
std::vector<float> texels_of(int line, int width, int floats_per_texel) {
    std::vector<float> texels(size_t(width) * size_t(floats_per_texel));
    for (int x = 0; x < width; ++x)
        for (int c = 0; c < 3; ++c)
            texels[size_t(x * floats_per_texel + c)] =
                float(1 + std::sin(0.3 * x + c) + 0.1 * line + (line == 0 && x == 5 ? 1e6 : 0));
    return texels;
}

// The integral itself, texel by texel in fp64.
std::complex<double> direct(const std::vector<float>& texels, int floats_per_texel, int channel,
                            int m, int width) {
    std::complex<double> sum = 0;
    for (int x = 0; x < width; ++x) {
        const double left = 2 * pi * x / width - pi, right = 2 * pi * (x + 1) / width - pi;
        const auto wave = [&](double phi) { return std::polar(1.0, -m * phi); };
        const std::complex<double> integral =
            m == 0 ? right - left : (wave(right) - wave(left)) / std::complex<double>(0, -m);
        sum += integral * double(texels[size_t(x * floats_per_texel + channel)]);
    }
    return sum;
}

TEST(LineFourier, IsTheIntegralOverEachTexel) {
    constexpr int orders = 50;
    for (const int width : {2, 6, 20, 26}) {       // fewer texels than orders
        for (const int line_count : {1, 2, 11}) {  // pairs, blocks and what is left of them
            for (const int floats_per_texel : {3, 4}) {
                LineFourier fourier(line_count, width, orders);
                std::vector<std::vector<float>> lines;
                std::vector<const float*> pointers;
                for (int i = 0; i < line_count; ++i)
                    lines.push_back(texels_of(i, width, floats_per_texel));
                for (const auto& line : lines) pointers.push_back(line.data());
                fourier.add(0, pointers, floats_per_texel);
                for (int m = 0; m < orders; ++m)
                    for (int c = 0; c < 3; ++c)
                        for (int i = 0; i < line_count; ++i) {
                            const auto truth =
                                direct(lines[size_t(i)], floats_per_texel, c, m, width);
                            // fp32: the stated 1e-7 of the largest, shared with the line beside
                            // it, for each of a few additions.
                            const double largest = (i < 2 ? 1e6 : 20) * 2 * pi / width;
                            const float* real = fourier.order(m) + c * line_count + i;
                            EXPECT_NEAR(real[0], truth.real(), 3e-7 * largest) << m << " " << c;
                            EXPECT_NEAR(real[3 * line_count], truth.imag(), 3e-7 * largest);
                        }
            }
        }
    }
}

TEST(LineKernels, AddAndSquareEveryValueOnce) {
    for (const size_t count : {1, 3, 16, 33, 100}) {
        std::vector<float> values(count), a(count, 1.0f), b(count, -2.0f);
        for (size_t i = 0; i < count; ++i) values[i] = float(i) - 7.5f;
        const float weights[] = {2.0f, -0.5f};
        float* const lines[] = {a.data(), b.data()};
        add_to_lines(values.data(), count, weights, lines);
        double squares = 0;
        for (size_t i = 0; i < count; ++i) {
            EXPECT_EQ(a[i], 1 + 2 * values[i]);
            EXPECT_EQ(b[i], -2 - 0.5f * values[i]);
            squares += double(values[i]) * double(values[i]);
        }
        EXPECT_NEAR(sum_of_squares(values.data(), count), squares, 1e-12 * squares);
    }
}

}  // namespace
}  // namespace splitsum
