#include "splitsum/filter/sequence.h"

#include "splitsum/math/low_discrepancy.h"

namespace splitsum {
namespace {

// The distance between positions of SplitMix64: 2^64 divided by the golden ratio, odd.
constexpr uint64_t step = 0x9e3779b97f4a7c15;

// SplitMix64's finalizer (Stafford 2011, "Better Bit Mixing", variant 13).
uint64_t mixed(uint64_t bits) {
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111eb;
    return bits ^ (bits >> 31);
}

// Mixed twice, so that neighbouring keys start nowhere near each other in the sequence.
uint64_t position_of(const PointKey& key) {
    const uint64_t seeded = mixed((uint64_t(key.seed) << 32 | key.stream) + step);
    return mixed(seeded + key.direction);
}

// Cell centres, so that neither 0 nor 1 occurs.
Vec2d point_of(uint64_t bits) {
    return {(double(bits >> 32) + 0.5) * 0x1p-32, (double(bits & 0xffffffff) + 0.5) * 0x1p-32};
}

double wrapped(double x) { return x < 1 ? x : x - 1; }

}  // namespace

PointList PointList::hammersley(uint32_t count) {
    PointList points;
    points.count_ = count;
    return points;
}

PointList PointList::shifted_hammersley(uint32_t count, const PointKey& key) {
    PointList points = hammersley(count);
    points.offset_ = point_of(mixed(position_of(key)));
    return points;
}

PointList PointList::random(const PointKey& key) {
    PointList points;
    points.sequence_ = PointSequence::random;
    points.position_ = position_of(key);
    return points;
}

Vec2d PointList::operator[](uint32_t i) const {
    if (sequence_ == PointSequence::random) return point_of(mixed(position_ + (i + 1ULL) * step));
    const Vec2d point = splitsum::hammersley(i, count_) + offset_;
    return {wrapped(point.x), wrapped(point.y)};
}

PointList unbiased_points(PointSequence sequence, uint32_t count, const PointKey& key) {
    return sequence == PointSequence::random ? PointList::random(key)
                                             : PointList::shifted_hammersley(count, key);
}

}  // namespace splitsum
