#include "splitsum/math/low_discrepancy.h"

#include <gtest/gtest.h>

#include <vector>

namespace splitsum {
namespace {

TEST(RadicalInverse, MirrorsTheBits) {
    EXPECT_EQ(radical_inverse_base2(0), 0.0);
    EXPECT_EQ(radical_inverse_base2(1), 0.5);
    EXPECT_EQ(radical_inverse_base2(6), 0.375);
    EXPECT_EQ(radical_inverse_base2(0x80000000U), 0x1p-32);
    EXPECT_EQ(radical_inverse_base2(0xffffffffU), 1 - 0x1p-32);
}

// A (0, m, 2)-net: every elementary box of area 2^-m holds exactly one of the 2^m points.
TEST(Hammersley, PutsOnePointInEveryElementaryBox) {
    constexpr uint32_t m = 8;
    constexpr uint32_t count = 1U << m;
    for (uint32_t columns_log2 = 0; columns_log2 <= m; ++columns_log2) {
        const uint32_t columns = 1U << columns_log2;
        const uint32_t rows = count / columns;
        std::vector<int> hits(count, 0);
        for (uint32_t i = 0; i < count; ++i) {
            const Vec2d point = hammersley(i, count);
            const auto x = static_cast<uint32_t>(point.x * columns);
            const auto y = static_cast<uint32_t>(point.y * rows);
            ++hits[y * columns + x];
        }
        for (const int hit : hits) EXPECT_EQ(hit, 1) << columns << " columns";
    }
}

TEST(Hammersley, KeepsTheFirstAxisInside) {
    for (const uint32_t count : {1U, 2U, 3U, 1000U})
        for (uint32_t i = 0; i < count; ++i) {
            EXPECT_GT(hammersley(i, count).x, 0);
            EXPECT_LT(hammersley(i, count).x, 1);
        }
}

}  // namespace
}  // namespace splitsum
