#include "splitsum/imageio/half_detail.h"

#include <bit>

namespace splitsum {

// A half is 1 sign, 5 exponent and 10 mantissa bits, a float 1, 8 and 23. With exponent and mantissa
// moved to their places in a float, the number is too small by 2^(127 - 15), the difference of the
// exponents' biases, and that holds for subnormal halves as well: one exact product sets both right.
// Infinite and NaN alone need the largest exponent instead. No branch, so that the compiler widens
// many at once.
void widen_halves(const uint16_t* halves, size_t count, float* floats) {
    const float bias = 0x1p112f;
    for (size_t i = 0; i < count; ++i) {
        const uint32_t half = halves[i];
        const uint32_t magnitude = half & 0x7fff;
        const uint32_t finite =
            std::bit_cast<uint32_t>(std::bit_cast<float>(magnitude << 13) * bias);
        const uint32_t exponent = magnitude >= 0x7c00 ? 0x7f800000 : 0;
        floats[i] = std::bit_cast<float>(finite | exponent | (half & 0x8000) << 16);
    }
}

}  // namespace splitsum
