#pragma once

#include <algorithm>
#include <cmath>

#include "splitsum/filter/mis_light.h"
#include "splitsum/filter/mis_lobe.h"
#include "splitsum/filter/sequence.h"

namespace splitsum {

// Multiple importance sampling (Veach & Guibas 1995): both strategies, lobe and light, estimate the
// same integral of f = L K / ∫ K, each weighted at every direction by a share of it,
//
//     1/n_1 sum_i w(n_1 p_1, n_2 p_2) f / p_1   +   1/n_2 sum_j w(n_2 p_2, n_1 p_1) f / p_2,
//
// which is unbiased for every w with w(a, b) + w(b, a) = 1.

/// a² / (a² + b²): the power heuristic with beta = 2. `own` > 0.
struct PowerShare {
    double operator()(double own, double other) const {
        const double ratio = other / own;
        return 1 / (1 + ratio * ratio);
    }
};

/// a / (a + b): the balance heuristic. `own` > 0.
struct BalanceShare {
    double operator()(double own, double other) const { return 1 / (1 + other / own); }
};

/// What both strategies draw from: `count` samples in all. Each gets half, the lobe one more where
/// the number is odd; a flat light gets none.
struct MisPoints {
    int lobe_count;
    int light_count;
    PointList lobe;
    PointList light;

    MisPoints(const LightSampler& sampler, int count, PointSequence sequence, PointKey key);
};

/// An estimate and, for each channel, its standard error from the spread of the samples: right for
/// random points, too large for evenly spread ones.
struct MisEstimate {
    Vec3d mean;
    Vec3d standard_error;
};

/// Adds up samples and their squares.
class SampleMoments {
public:
    void add(const Vec3d& value) {
        sum_ += value;
        squares_ += value * value;
        ++count_;
    }

    Vec3d mean() const { return count_ == 0 ? Vec3d(0) : sum_ / double(count_); }

    /// The squared standard error of the mean. A single sample has no spread: its own square.
    Vec3d variance_of_mean() const {
        if (count_ < 2) return squares_;
        const double n = count_;
        return max(squares_ - sum_ * sum_ / n, Vec3d(0)) / (n * (n - 1));
    }

private:
    Vec3d sum_{0};
    Vec3d squares_{0};
    int count_ = 0;
};

/// The light's mean over the lobe about `towards`, by the points. `share` is w above.
template <class Share>
MisEstimate mis_estimate(const LightSampler& light, const LobeSampler& lobe, const Vec3d& towards,
                         const MisPoints& points, const Share& share) {
    const double lobe_count = points.lobe_count, light_count = points.light_count;
    const Basis basis = basis_around(towards);
    SampleMoments by_lobe, by_light;
    for (int i = 0; i < points.lobe_count; ++i) {
        const auto [d, versine] = lobe.sample(points.lobe[uint32_t(i)]);
        const Vec3d direction = basis.tangent * d.x + basis.bitangent * d.y + basis.normal * d.z;
        const auto from = light.towards(direction);
        const double pdf = lobe.pdf(versine);
        by_lobe.add(from.light *
                    (share(lobe_count * pdf, light_count * from.pdf) * lobe.value(versine) / pdf));
    }
    for (int i = 0; i < points.light_count; ++i) {
        const auto from = light.sample(points.light[uint32_t(i)]);
        const Vec3d chord = from.direction - towards;
        const double versine = 0.5 * dot(chord, chord);
        by_light.add(from.light * (share(light_count * from.pdf, lobe_count * lobe.pdf(versine)) *
                                   lobe.value(versine) / from.pdf));
    }
    return {light.floor() + by_lobe.mean() + by_light.mean(),
            sqrt(by_lobe.variance_of_mean() + by_light.variance_of_mean())};
}

}  // namespace splitsum
