#pragma once

#include <vector>

#include "splitsum/filter/sample_set.h"
#include "splitsum/sphere/environment.h"
#include "splitsum/sphere/ring_pyramid.h"

namespace splitsum::benchmarks {

/// The method `filtered` as one would write it first: a loop over texels and in it a loop over
/// samples, in single precision with the C library's arctangent, without SIMD and threads. What is
/// the same for all texels (pyramid, sample set, level of each sample) is computed once, as in the
/// library.
class ScalarFiltered {
public:
    ScalarFiltered(const Environment& environment, const Lobe& lobe, int samples);

    /// The filtered radiance towards a unit direction in panorama space. `lookup` reads a level
    /// towards a direction: one of the two below.
    template <class Lookup>
    Vec3 towards(const Vec3d& direction, const Lookup& lookup) const;

    /// With everything in single precision: the loop that others are compared with.
    Vec3 towards_in_float(const Vec3d& direction) const;

    /// Through radiance_towards(RingLevel), whose azimuths and interpolation are in fp64.
    Vec3 towards_in_double(const Vec3d& direction) const;

private:
    RingPyramid pyramid_;
    SampleSet samples_;
    std::vector<const RingLevel*> level_of_sample_;
};

}  // namespace splitsum::benchmarks
