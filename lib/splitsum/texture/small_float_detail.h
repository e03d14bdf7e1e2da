#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace splitsum {

// The packed floats of graphics hardware, one value or texel at a time. All arguments are clamped by
// the caller to what the format holds.

/// The nearest float without sign of 5 exponent bits (bias 15) and `mantissa_bits` mantissa bits,
/// ties to even, for a value in [0, the largest finite one].
template <int mantissa_bits>
uint32_t bits_of_unsigned_float(float value) {
    constexpr float smallest_normal = 0x1p-14f;
    if (value < smallest_normal) {
        // A denormal is a multiple of 2^-(14 + mantissa_bits). Adding the power of two whose last
        // bit has that weight lets the adder round to it; a carry makes the smallest normal, whose
        // bits follow the largest denormal's.
        constexpr float ruler = static_cast<float>(1 << (9 - mantissa_bits));
        return std::bit_cast<uint32_t>(value + ruler) - std::bit_cast<uint32_t>(ruler);
    }
    constexpr int dropped = 23 - mantissa_bits;
    const uint32_t bits = std::bit_cast<uint32_t>(value);
    const uint32_t even = (bits >> dropped) & 1;
    const uint32_t rounded = (bits + (1u << (dropped - 1)) - 1 + even) >> dropped;
    return rounded - ((127 - 15) << mantissa_bits);
}

/// 2^exponent, for exponents of normal doubles.
inline double power_of_two(int exponent) {
    return std::bit_cast<double>(static_cast<uint64_t>(exponent + 1023) << 52);
}

/// The nearest shared-exponent texel: three 9-bit mantissas from bit 0 up, red lowest, and a 5-bit
/// exponent e on top; a channel is mantissa * 2^(e - 24). Channels in [0, 65408].
/// EXT_texture_shared_exponent: the exponent is that of the largest channel, one more where
/// rounding carries that channel's mantissa to 512.
inline uint32_t bits_of_rgb9e5(const std::array<float, 3>& rgb) {
    const float largest = std::max({rgb[0], rgb[1], rgb[2]});
    const int log2_floor = static_cast<int>(std::bit_cast<uint32_t>(largest) >> 23) - 127;
    int exponent = std::max(-16, log2_floor) + 16;
    // In double, where adding a half does not round.
    const auto mantissa_of = [&](float channel) {
        return static_cast<uint32_t>(channel * power_of_two(24 - exponent) + 0.5);
    };
    if (mantissa_of(largest) == 512) ++exponent;
    return mantissa_of(rgb[0]) | mantissa_of(rgb[1]) << 9 | mantissa_of(rgb[2]) << 18 |
           static_cast<uint32_t>(exponent) << 27;
}

inline std::array<float, 3> rgb_of_rgb9e5(uint32_t bits) {
    const double unit = power_of_two(static_cast<int>(bits >> 27) - 24);
    const auto channel = [&](int shift) {
        return static_cast<float>(((bits >> shift) & 0x1ff) * unit);
    };
    return {channel(0), channel(9), channel(18)};
}

}  // namespace splitsum
