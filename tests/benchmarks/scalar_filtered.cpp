#include "scalar_filtered.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace splitsum::benchmarks {
namespace {

// Linear between the two texel centres of a ring around azimuth `u` (in turns).
Vec3 along_ring(const RingLevel& level, size_t ring_index, float u) {
    const RingLevel::Ring& ring = level.rings[ring_index];
    const float x = u * ring.texel_count - 0.5f;
    const float column = std::floor(x);
    const float* left = level.texels.data() + 4 * (ptrdiff_t(ring.first) + ptrdiff_t(column));
    const float t = x - column;
    const Vec3 a(left[0], left[1], left[2]), b(left[4], left[5], left[6]);
    return a + t * (b - a);
}

// Bilinear on the rings of a level, in single precision throughout.
Vec3 radiance_in_float(const RingLevel& level, const Vec3& d) {
    constexpr float turn = 2 * std::numbers::pi_v<float>;
    const float u = 0.5f + std::atan2(d.x, d.z) / turn;
    const float v = 2 * std::atan2(std::sqrt(d.x * d.x + d.z * d.z), d.y) / turn;
    const float y = v * float(level.ring_count) - 0.5f;
    const float ring = std::min(std::floor(y), float(level.ring_count - 1));
    const size_t above = size_t(ring + 1);
    const Vec3 upper = along_ring(level, above, u), lower = along_ring(level, above + 1, u);
    return upper + (y - ring) * (lower - upper);
}

// The level whose texels are nearest in solid angle to sqrt(2) times what the sample stands for;
// the factor is that of filter/sampled.cpp, so that both answer with the same numbers.
const RingLevel& level_of_footprint(const RingPyramid& pyramid, double finest, double footprint) {
    const double halvings = std::round(std::log2(std::numbers::sqrt2 * footprint / finest));
    const double last = double(pyramid.levels.size() - 1);
    return pyramid.levels[size_t(std::clamp(halvings, 0.0, last))];
}

}  // namespace

ScalarFiltered::ScalarFiltered(const Environment& environment, const Lobe& lobe, int samples)
    : pyramid_(ring_pyramid(environment)), samples_(importance_samples(lobe, samples)) {
    const double finest = pyramid_.levels.front().solid_angle();
    for (size_t i = 0; i < samples_.count; ++i)
        level_of_sample_.push_back(
            &level_of_footprint(pyramid_, finest, double(samples_.solid_angle[i])));
}

template <class Lookup>
Vec3 ScalarFiltered::towards(const Vec3d& direction, const Lookup& lookup) const {
    const double azimuth = std::atan2(direction.x, direction.z);
    const Vec3 normal(direction);
    const Vec3 east(Vec3d(std::cos(azimuth), 0, -std::sin(azimuth)));
    const Vec3 south = cross(normal, east);
    Vec3 sum(0);
    for (size_t i = 0; i < samples_.count; ++i) {
        const Vec3 l = samples_.x[i] * east + samples_.y[i] * south + samples_.z[i] * normal;
        sum += samples_.weight[i] * lookup(*level_of_sample_[i], l);
    }
    return sum;
}

Vec3 ScalarFiltered::towards_in_float(const Vec3d& direction) const {
    return towards(direction, radiance_in_float);
}

Vec3 ScalarFiltered::towards_in_double(const Vec3d& direction) const {
    return towards(direction, [](const RingLevel& level, const Vec3& l) {
        return radiance_towards(level, Vec3d(l));
    });
}

}  // namespace splitsum::benchmarks
