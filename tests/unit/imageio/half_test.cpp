#include "splitsum/imageio/half_detail.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <vector>

namespace splitsum {
namespace {

float widened(uint16_t half) {
    float value = 0;
    widen_halves(&half, 1, &value);
    return value;
}

// The definition: (-1)^s 2^(e - 15) (1 + m / 1024), or m / 1024 2^-14 for e = 0.
TEST(Halves, AreWidenedExactly) {
    for (int half = 0; half < 0x10000; ++half) {
        const int exponent = half >> 10 & 31, mantissa = half & 1023;
        if (exponent == 31) continue;
        const double magnitude =
            exponent == 0 ? std::ldexp(mantissa, -24) : std::ldexp(1024 + mantissa, exponent - 25);
        const float value = widened(uint16_t(half));
        ASSERT_EQ(value, half & 0x8000 ? -magnitude : magnitude) << half;
        ASSERT_EQ(std::signbit(value), (half & 0x8000) != 0) << half;
    }
}

TEST(Halves, KeepInfinitiesAndTheBitsOfNaN) {
    EXPECT_EQ(widened(0x7c00), std::numeric_limits<float>::infinity());
    EXPECT_EQ(widened(0xfc00), -std::numeric_limits<float>::infinity());
    for (const int mantissa : {1, 0x155, 0x200, 0x3ff}) {
        EXPECT_EQ(std::bit_cast<uint32_t>(widened(uint16_t(0x7c00 | mantissa))),
                  0x7f800000U | uint32_t(mantissa) << 13);
        EXPECT_TRUE(std::isnan(widened(uint16_t(0xfc00 | mantissa))));
    }
}

TEST(Halves, AreWidenedToTheEndAndNoFurther) {
    for (size_t count = 0; count < 68; ++count) {
        std::vector<uint16_t> halves(count, 0x3c00);
        std::vector<float> floats(count + 1, -7);
        widen_halves(halves.data(), count, floats.data());
        for (size_t i = 0; i < count; ++i) ASSERT_EQ(floats[i], 1) << i << " of " << count;
        ASSERT_EQ(floats[count], -7);
    }
}

}  // namespace
}  // namespace splitsum
