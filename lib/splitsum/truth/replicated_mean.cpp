#include "splitsum/truth/replicated_mean.h"

#include <algorithm>
#include <numeric>

#include "splitsum/base/random.h"

namespace splitsum {
namespace {

constexpr double count = ReplicatedMean::replicates;

// The squared standard error of the mean of values of replicates, from their spread.
template <class Value, class ValueOf>
Value spread(const Value& mean, const ValueOf& value_of) {
    Value squares{0};
    for (size_t i = 0; i < ReplicatedMean::replicates; ++i) {
        const Value miss = value_of(i) - mean;
        squares += miss * miss;
    }
    return squares / (count * (count - 1));
}

// Hashes of hashes, so that neighbouring surfaces, replicates and seeds have nothing in common.
uint32_t stream_of(const SurfaceKey& key, uint32_t replicate) {
    return mix_bits(mix_bits(mix_bits(key.seed ^ 0x9e3779b9U) + key.surface) + replicate);
}

ScrambledSobol sequence_of(uint32_t stream, uint32_t use) {
    const auto number = [&](uint32_t i) { return mix_bits(stream + 4 * use + i); };
    return ScrambledSobol({number(0), number(1), number(2), number(3)});
}

}  // namespace

SurfaceSequence::SurfaceSequence(const SurfaceKey& key, uint32_t replicate)
    : lobe_(sequence_of(stream_of(key, replicate), 0)),
      cosine_(sequence_of(stream_of(key, replicate), 1)),
      light_(sequence_of(stream_of(key, replicate), 2)) {}

Vec3d ReplicatedMean::mean() const {
    if (points_ == 0) return Vec3d(0);
    return std::accumulate(sums_.begin(), sums_.end(), Vec3d(0)) / (count * points_);
}

Vec3d ReplicatedMean::variance_of_mean() const {
    if (points_ == 0) return Vec3d(0);
    return spread(mean(), [&](size_t i) { return sums_[i] / double(points_); });
}

double ReplicatedMean::variance_of_mean(const Vec3d& weights) const {
    if (points_ == 0) return 0;
    return spread(dot(weights, mean()), [&](size_t i) { return dot(weights, sums_[i]) / points_; });
}

}  // namespace splitsum
