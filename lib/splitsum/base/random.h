#pragma once

#include <cstdint>

namespace splitsum {

/// A well-mixed 32-bit hash. Constants: Mueller's two-round "triple32"-style integer hash, found by
/// exhaustive search for low bias (Wellons 2018, "Prospecting for Hash Functions", lowbias32).
inline uint32_t mix_bits(uint32_t key) {
    key ^= key >> 16;
    key *= 0x7feb352dU;
    key ^= key >> 15;
    key *= 0x846ca68bU;
    key ^= key >> 16;
    return key;
}

/// A float in [0, 1) that depends only on the key: the same texel gets the same number whichever
/// thread visits it, so no generator state has to be carried through a parallel loop.
inline float unit_float(uint32_t key) { return static_cast<float>(mix_bits(key) >> 8) * 0x1p-24f; }

}  // namespace splitsum
