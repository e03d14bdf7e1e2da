#include "splitsum/filter/rows_to_rings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "splitsum/sphere/environment.h"

namespace splitsum {
namespace {

constexpr double pi = std::numbers::pi;

struct Rings {
    std::vector<std::vector<float>> lines;
    double theta(size_t ring) const { return pi * (double(ring) + 0.5) / double(lines.size()); }
};

Rings gathered(const Environment& environment, int ring_count) {
    RowsToRings rings(environment.height(), ring_count);
    Rings result;
    const size_t line_floats = 4 * size_t(environment.width());
    rings.add_rows(environment.height(), environment.texels().data(), 4,
                   [&](int first, std::span<const float* const> lines) {
                       EXPECT_EQ(size_t(first), result.lines.size());
                       for (const float* line : lines)
                           result.lines.emplace_back(line, line + line_floats);
                   });
    return result;
}

TEST(RowsToRings, KeepsIntegralsAgainstSmoothFunctions) {
    // One lit texel at a time, at the poles, beside them and elsewhere; against the integral of f
    // over the texel's row. f is a polynomial in the cosine and sine of theta that goes on smoothly
    // over the poles only together with its azimuth, as a harmonic of odd order does.
    constexpr int ring_count = 24;
    const auto f = [](double theta) { return std::sin(theta) * std::cos(3 * theta); };
    for (const int height : {48, 200, 333})
        for (const int row : {0, 1, height / 3, height - 2, height - 1}) {
            const int column = 3;
            Environment environment(height);
            environment.set_texel(column, row, Vec3(1, 2, 3));
            const Rings rings = gathered(environment, ring_count);
            ASSERT_EQ(rings.lines.size(), size_t(ring_count));
            double sum = 0;
            for (size_t k = 0; k < rings.lines.size(); ++k) {
                const size_t opposite = size_t((column + height) % (2 * height));
                sum += f(rings.theta(k)) * (double(rings.lines[k][4 * size_t(column) + 1]) -
                                            double(rings.lines[k][4 * opposite + 1]));
            }
            double expected = 0;
            constexpr int steps = 200;
            for (int i = 0; i < steps; ++i) {
                const double theta = pi * (row + (i + 0.5) / steps) / height;
                expected += 2 * f(theta) * std::sin(theta) * pi / height / steps;
            }
            EXPECT_NEAR(sum, expected, 2e-5 * pi / height) << row << " of " << height;
        }
}

TEST(RowsToRings, KeepsTheWholeLight) {
    Environment white(100);
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 200; ++x) white.set_texel(x, y, Vec3(1));
    double sum = 0;
    for (const auto& line : gathered(white, 40).lines) sum += double(line[0]);
    EXPECT_NEAR(sum, 2, 1e-6);  // ∫ sin theta dtheta
}

}  // namespace
}  // namespace splitsum
