#pragma once

#include <cstdint>

#include "splitsum/math/vec.h"
#include "splitsum/plan/sampling_plan.h"

namespace splitsum {

/// Names one list of points. Equal keys give equal points, whichever thread asks.
struct PointKey {
    uint32_t seed = 0;       ///< of the plan
    uint32_t direction = 0;  ///< of the texel (Directions::first_key and on)
    uint32_t stream = 0;     ///< tells apart the lists that one texel uses
};

/// Points of [0, 1)², each a function of the key and its index: no generator, no state.
class PointList {
public:
    /// Hammersley's `count` points, the same for every direction.
    static PointList hammersley(uint32_t count);

    /// Hammersley's points, all moved by one offset drawn from the key, modulo 1 (Cranley &
    /// Patterson 1976, "Randomization of Number Theoretic Methods for Multiple Integration"): as
    /// even as before, and every point is uniform, so that means over keys are unbiased.
    static PointList shifted_hammersley(uint32_t count, const PointKey& key);

    /// Independent uniform points: SplitMix64's output at a position in its sequence (Steele, Lea &
    /// Flood 2014, "Fast Splittable Pseudorandom Number Generators"), 32 bits a coordinate.
    static PointList random(const PointKey& key);

    Vec2d operator[](uint32_t i) const;

private:
    PointSequence sequence_ = PointSequence::hammersley;
    uint32_t count_ = 0;     // of hammersley
    Vec2d offset_{0, 0};     // of hammersley
    uint64_t position_ = 0;  // of random
};

/// Points whose means over keys are unbiased, of the sequence asked for.
PointList unbiased_points(PointSequence sequence, uint32_t count, const PointKey& key);

}  // namespace splitsum
