#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "splitsum/filter/sample_set.h"
#include "splitsum/math/vec.h"
#include "splitsum/sphere/environment.h"
#include "splitsum/sphere/ring_pyramid.h"

namespace splitsum {

/// The rotation that carries +Z of a sample set to a texel's direction, in single precision.
struct Frame {
    Vec3 tangent;
    Vec3 bitangent;
    Vec3 normal;
};

/// The frame about a unit direction whose tangent points east and whose bitangent points south,
/// turned about the direction by `angle` radians. It follows a rotation of the panorama about y,
/// and changes smoothly everywhere but at the two poles.
Frame frame_towards(const Vec3d& direction, double angle);

/// Which level of a pyramid each sample reads, as tables a SIMD loop can load.
struct RingLookups {
    std::vector<const RingLevel*> level;  ///< one a sample, padded like the sample set
    std::vector<float> ring_count;        ///< of that level
};

// The sums below are nearly the whole cost of the sampling methods. They run on the widest
// instruction set of the machine (Highway, dispatched at run time) with lanes over samples. The
// azimuth and polar angle come from a polynomial arctangent: within 1e-7 turns (tested).

/// The weighted sum of the environment's texels that the samples point into.
Vec3 sum_of_texels(const Environment& environment, const SampleSet& samples, const Frame& frame);

/// The weighted sum of ring levels, bilinear between texel centres.
Vec3 sum_of_rings(const RingLookups& lookups, const SampleSet& samples, const Frame& frame);

}  // namespace splitsum
