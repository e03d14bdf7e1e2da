#include "splitsum/math/scrambled_sobol.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "splitsum/base/random.h"

namespace splitsum {
namespace {

ScrambledSobol sequence_of(uint32_t seed) {
    return ScrambledSobol({mix_bits(4 * seed + 1), mix_bits(4 * seed + 2), mix_bits(4 * seed + 3),
                           mix_bits(4 * seed + 4)});
}

// Every elementary interval, 2^a by 2^(m - a) to the unit square, of every block of 2^m points.
TEST(ScrambledSobol, HasOnePointInEveryElementaryInterval) {
    for (const uint32_t seed : {0u, 1u, 77u})
        for (const int m : {1, 4, 8, 11})
            for (const uint32_t block : {0u, 1u, 5u})
                for (int a = 0; a <= m; ++a) {
                    const ScrambledSobol sequence = sequence_of(seed);
                    std::vector<int> counts(size_t(1) << m, 0);
                    for (uint32_t i = 0; i < 1u << m; ++i) {
                        const Vec2d p = sequence[(block << m) + i];
                        const size_t column = size_t(std::ldexp(p.x, a));
                        const size_t row = size_t(std::ldexp(p.y, m - a));
                        ++counts[(row << a) + column];
                    }
                    for (const int count : counts) ASSERT_EQ(count, 1) << m << ' ' << a;
                }
}

TEST(ScrambledSobol, KeepsAwayFromTheEnds) {
    for (uint32_t seed = 0; seed < 100; ++seed)
        for (const uint32_t i : {0u, 1u, 0xffffffffu}) {
            const Vec2d p = sequence_of(seed)[i];
            EXPECT_TRUE(p.x > 0 && p.y > 0 && p.x < 1 && p.y < 1);
        }
}

// Any one point is uniform over keys: the mean of a step and of a product, in standard errors.
TEST(ScrambledSobol, IsUnbiasedOverKeys) {
    constexpr uint32_t keys = 40000;
    for (const uint32_t i : {0u, 3u, 1000u}) {
        double below = 0, product = 0;
        for (uint32_t key = 0; key < keys; ++key) {
            const Vec2d p = sequence_of(key)[i];
            below += (p.x < 0.3) - 0.3;
            product += (p.x - 0.5) * (p.y - 0.5) * 12;
        }
        EXPECT_LT(std::abs(below), 4 * std::sqrt(0.21 * keys)) << i;
        EXPECT_LT(std::abs(product), 4 * std::sqrt(keys)) << i;
    }
}

// A smooth integrand gains more than its square root: N^-1.5 in theory.
TEST(ScrambledSobol, IntegratesSmoothFunctionsFast) {
    const auto spread = [](uint32_t count) {
        double sum = 0, squares = 0;
        for (uint32_t key = 0; key < 200; ++key) {
            double mean = 0;
            for (uint32_t i = 0; i < count; ++i) {
                const Vec2d p = sequence_of(key)[i];
                mean += std::exp(p.x * p.y + p.x) / count;
            }
            sum += mean, squares += mean * mean;
        }
        return std::sqrt(squares / 200 - sum * sum / 200 / 200);
    };
    EXPECT_LT(spread(1024), spread(64) / 40);  // 16^1.33; random points: / 4
}

}  // namespace
}  // namespace splitsum
