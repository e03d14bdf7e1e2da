#pragma once

#include <vector>

#include "splitsum/brdf/lobe.h"
#include "splitsum/filter/sequence.h"

namespace splitsum {

/// Directions about +Z and weights that stand for a lobe: because n = v = R they are the same for
/// every texel of a level and are computed once. One array a component, padded with zero weights
/// to a multiple of `padding` so that SIMD loops need no remainder.
struct SampleSet {
    static constexpr size_t padding = 16;

    std::vector<float> x, y, z;      ///< unit directions
    std::vector<float> weight;       ///< sums to 1
    std::vector<float> solid_angle;  ///< steradians that each sample stands for: 1 / (N pdf)
    size_t count = 0;                ///< without the padding
};

/// The first `count` points of the list through the lobe's own distribution.
///
/// GGX: tan² theta_h = alpha² xi / (1 - xi) (Walter et al. 2007, eq. 35), doubled to the reflected
/// direction, l = 2 (n·h) h - n; pdf = D / 4 because v·h = n·h; the weight left over is n·l. The
/// half vectors beyond 45 degrees, whose reflections lie below the horizon, are left out of the
/// range of xi, so that all points count. sin² theta_h comes from xi itself: 1 - cos² would lose
/// 88 % at perceptual roughness 0.02 in single precision.
/// Cosine: sin² theta = xi with equal weights.
SampleSet importance_samples(const Lobe& lobe, int count, const PointList& points);

/// Hammersley's points through the lobe's own distribution.
SampleSet importance_samples(const Lobe& lobe, int count);

/// About `count` points of a uniform grid in (theta, phi), four times as many around as down, with
/// weights K sin theta.
SampleSet riemann_samples(const Lobe& lobe, int count);

}  // namespace splitsum
