#pragma once

#include <cstdint>

#include "splitsum/math/vec.h"

namespace splitsum {

namespace scrambled_sobol_detail {

inline uint32_t reversed(uint32_t i) {
    i = (i << 16) | (i >> 16);
    i = ((i & 0x00ff00ffU) << 8) | ((i & 0xff00ff00U) >> 8);
    i = ((i & 0x0f0f0f0fU) << 4) | ((i & 0xf0f0f0f0U) >> 4);
    i = ((i & 0x33333333U) << 2) | ((i & 0xccccccccU) >> 2);
    return ((i & 0x55555555U) << 1) | ((i & 0xaaaaaaaaU) >> 1);
}

// Pascal's triangle modulo 2 times the bits of i. C(k, j) is odd where every bit of j is one of k
// (Lucas), so the product is a sum over supersets, one step for each of the five bits of a place.
inline uint32_t times_pascal(uint32_t i) {
    i ^= (i >> 1) & 0x55555555U;
    i ^= (i >> 2) & 0x33333333U;
    i ^= (i >> 4) & 0x0f0f0f0fU;
    i ^= (i >> 8) & 0x00ff00ffU;
    return i ^ (i >> 16);
}

// Flips each bit by a hash of those below it (Laine & Karras 2011, "Stratified Sampling for
// Stochastic Transparency"; constants of Vegdahl 2021).
inline uint32_t flipped_by_lower_bits(uint32_t bits, uint32_t key) {
    bits ^= bits * 0x3d20adeaU;
    bits += key;
    bits *= (key >> 16) | 1;
    bits ^= bits * 0x05526c56U;
    return bits ^ (bits * 0x53a22864U);
}

}  // namespace scrambled_sobol_detail

/// Sobol's sequence in two dimensions, scrambled as Owen does it (1995, "Randomly Permuted
/// (t,m,s)-Nets and (t,s)-Sequences") by hashes (Burley 2020, "Practical Hash-Based Owen
/// Scrambling", JCGT 9(4)): in every block of 2^m points, m <= 32, each elementary interval of area
/// 2^-m has one point. A last exclusive or with random bits makes every single point uniform, so
/// that means over keys are unbiased. May be made longer at any time: point i does not depend on
/// the number.
class ScrambledSobol {
public:
    struct Key {
        uint32_t scramble_x, scramble_y, shift_x, shift_y;
    };

    explicit ScrambledSobol(const Key& key) : key_(key) {}

    /// In (0, 1)²: 0 and 1, where inverse distributions may be infinite, do not occur.
    Vec2d operator[](uint32_t i) const {
        using namespace scrambled_sobol_detail;
        const uint32_t x = reversed(flipped_by_lower_bits(i, key_.scramble_x)) ^ key_.shift_x;
        const uint32_t y =
            reversed(flipped_by_lower_bits(times_pascal(i), key_.scramble_y)) ^ key_.shift_y;
        return {(x + 0.5) * 0x1p-32, (y + 0.5) * 0x1p-32};
    }

private:
    Key key_;
};

}  // namespace splitsum
