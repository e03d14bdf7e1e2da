#pragma once

#include <array>
#include <cstdint>

#include "splitsum/math/scrambled_sobol.h"
#include "splitsum/math/vec.h"
#include "splitsum/truth/surface_light.h"

namespace splitsum {

/// Names the points that a surface is sampled with. Equal keys give equal points.
struct SurfaceKey {
    uint32_t seed = 0;
    uint32_t surface = 0;
};

/// The points of one replicate: three sequences that know nothing of each other.
class SurfaceSequence {
public:
    SurfaceSequence(const SurfaceKey& key, uint32_t replicate);

    SurfacePoints operator[](uint32_t i) const { return {lobe_[i], cosine_[i], light_[i]}; }

private:
    ScrambledSobol lobe_, cosine_, light_;
};

/// The mean of SurfaceLight::estimate over points that are evenly spread (math/scrambled_sobol.h),
/// and an honest standard error: several independent sequences, the replicates, each give an
/// unbiased mean, and their spread says how far off the mean of all may be. The error is smaller
/// than that of as many random points, and the estimate is of this error, with replicates - 1
/// degrees of freedom. What SurfaceLight knows in closed form is not in it.
class ReplicatedMean {
public:
    static constexpr uint32_t replicates = 8;

    /// Takes every replicate on to its first `points` points, at most 2^32 - 1.
    template <class Share>
    void extend(const SurfaceLight& light, const SurfaceKey& key, uint32_t points,
                const Share& share) {
        for (uint32_t replicate = 0; replicate < replicates; ++replicate) {
            const SurfaceSequence sequence(key, replicate);
            Vec3d sum(0);
            for (uint32_t i = points_; i < points; ++i) sum += light.estimate(sequence[i], share);
            sums_[replicate] += sum;
        }
        points_ = points;
    }

    /// Points of each replicate so far.
    uint32_t points() const { return points_; }

    /// 0 without points.
    Vec3d mean() const;

    /// The squared standard error of the mean of each channel; 0 without points.
    Vec3d variance_of_mean() const;

    /// The squared standard error of dot(weights, mean()).
    double variance_of_mean(const Vec3d& weights) const;

private:
    std::array<Vec3d, replicates> sums_{};
    uint32_t points_ = 0;
};

}  // namespace splitsum
