#pragma once

#include <cstdint>

#include "splitsum/math/vec.h"

namespace splitsum {

/// The bits of `i` mirrored about the binary point, in [0, 1): van der Corput's sequence in base 2.
/// Exact: all 32 bits fit a double.
inline double radical_inverse_base2(uint32_t i) {
    i = (i << 16) | (i >> 16);
    i = ((i & 0x00ff00ffU) << 8) | ((i & 0xff00ff00U) >> 8);
    i = ((i & 0x0f0f0f0fU) << 4) | ((i & 0xf0f0f0f0U) >> 4);
    i = ((i & 0x33333333U) << 2) | ((i & 0xccccccccU) >> 2);
    i = ((i & 0x55555555U) << 1) | ((i & 0xaaaaaaaaU) >> 1);
    return i * 0x1p-32;
}

/// Point i of Hammersley's set of `count` points: ((i + 1/2) / count, radical inverse of i). The
/// half keeps both ends of the first axis out, where an inverse distribution may be infinite.
inline Vec2d hammersley(uint32_t i, uint32_t count) {
    return {(i + 0.5) / count, radical_inverse_base2(i)};
}

}  // namespace splitsum
