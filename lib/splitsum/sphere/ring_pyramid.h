#pragma once

#include <cstdint>
#include <vector>

#include "splitsum/math/vec.h"
#include "splitsum/sphere/environment.h"

namespace splitsum {

/// One level of a RingPyramid: rings of equal height around the y axis, each cut into so many
/// texels that they are about as wide as high. All texels of a level cover nearly the same solid
/// angle, (pi / ring count)², from the equator to the poles, unlike those of a lat-long or cube
/// grid; a footprint therefore needs one level wherever it falls.
struct RingLevel {
    struct Ring {
        int32_t first;      ///< index of the ring's texel 0 in `texels`
        float texel_count;  ///< around the ring
    };

    int ring_count = 0;
    /// rings[i + 1] is ring i; the first and last continue over the poles: the ring next to the
    /// pole once more, turned by half a circle.
    std::vector<Ring> rings;
    /// Four floats a texel (RGB and 0). Each ring has one texel more at either end, a copy of the
    /// one that follows around the circle, so that an interpolation needs no wrapping.
    std::vector<float> texels;

    double solid_angle() const;  ///< of a texel, on average
};

/// The environment at ever coarser resolution, half an octave from level to level. Each texel is
/// the mean of the light over its extent, weighted by exact solid angles, so that every level has
/// the mean radiance of the environment.
struct RingPyramid {
    std::vector<RingLevel>
        levels;  ///< finest first; the last has two rings (one, if the input has)
};

/// Cost: about 3.5 passes over the environment; memory 2.2 times its own.
RingPyramid ring_pyramid(const Environment& environment);

/// The level's light towards `direction`: bilinear between texel centres, across the seam at ±pi
/// and over the poles. The scalar specification of the SIMD lookups in filter/.
Vec3 radiance_towards(const RingLevel& level, const Vec3d& direction);

/// The mean over the sphere in fp64.
Vec3d mean_radiance(const RingLevel& level);

}  // namespace splitsum
