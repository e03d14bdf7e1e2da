#include "splitsum/sphere/ring_pyramid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/base/parallel.h"
#include "splitsum/sphere/lat_long_average_detail.h"

namespace splitsum {
namespace {

constexpr double pi = std::numbers::pi;

// Texels about as wide as high, an even number so that the ring continues over the pole texel by
// texel, and no more than the source has columns.
int texels_around(int ring, int ring_count, int widest) {
    const double circumference = 2 * pi * std::sin(pi * (ring + 0.5) / ring_count);
    const int texels = 2 * int(std::ceil(0.5 * circumference / (pi / ring_count)));
    return std::clamp(texels, 2, std::max(2, widest));
}

// A row of the finer grid: its texels stand one after the other, `count` around the circle.
struct FineRow {
    const float* texels;
    int count;
};

// Adds weight * (mean of the fine row over each of sums.size() equal arcs) to the sums.
void add_row(const FineRow& row, double weight, std::vector<Vec3d>& sums) {
    const double ratio = double(row.count) / double(sums.size());
    for (size_t i = 0; i < sums.size(); ++i) {
        sums[i] += weight * mean_over_arc(row.texels, row.count, 4, double(i) * ratio,
                                          double(i + 1) * ratio);
    }
}

void store_texel(RingLevel& level, int64_t index, const Vec3d& radiance) {
    float* texel = level.texels.data() + 4 * index;
    for (int c = 0; c < 3; ++c) texel[c] = float(radiance[c]);
}

void store_ring(RingLevel& level, const RingLevel::Ring& ring, const std::vector<Vec3d>& texels) {
    const int count = int(texels.size());
    for (int i = -1; i <= count; ++i)
        store_texel(level, ring.first + i, texels[size_t((i + count) % count)]);
}

// Room for the rings and their copies beyond the poles; all texels black.
RingLevel empty_level(int ring_count, int widest) {
    RingLevel level;
    level.ring_count = ring_count;
    int next = 0;
    for (int i = -1; i <= ring_count; ++i) {
        const int count = texels_around(std::clamp(i, 0, ring_count - 1), ring_count, widest);
        level.rings.push_back({next + 1, float(count)});
        next += count + 2;
    }
    level.texels.assign(4 * size_t(next), 0.0f);
    return level;
}

// The level whose rows are averages of fine_row(0) .. fine_row(fine_count - 1).
template <class FineRowAt>
RingLevel averaged_level(int ring_count, int widest, int fine_count, const FineRowAt& fine_row) {
    RingLevel level = empty_level(ring_count, widest);
    parallel_rows(ring_count, [&](int i) {
        const RingLevel::Ring& ring = level.rings[size_t(i) + 1];
        std::vector<Vec3d> sums(size_t(ring.texel_count), Vec3d(0));
        const double v0 = double(i) / ring_count, v1 = double(i + 1) / ring_count;
        for (int y = int(v0 * fine_count); y < fine_count && y < v1 * fine_count; ++y) {
            const double from = std::max(v0, double(y) / fine_count);
            const double to = std::min(v1, double(y + 1) / fine_count);
            if (to > from) add_row(fine_row(y), zone_height(from, to) / zone_height(v0, v1), sums);
        }
        store_ring(level, ring, sums);
        if (i != 0 && i != ring_count - 1) return;
        std::rotate(sums.begin(), sums.begin() + std::ssize(sums) / 2, sums.end());
        if (i == 0) store_ring(level, level.rings.front(), sums);
        if (i == ring_count - 1) store_ring(level, level.rings.back(), sums);
    });
    return level;
}

RingLevel level_of_environment(const Environment& environment) {
    const size_t row_size = 4 * size_t(environment.width());
    return averaged_level(
        environment.height(), environment.width(), environment.height(), [&](int y) {
            return FineRow{environment.texels().data() + size_t(y) * row_size, environment.width()};
        });
}

RingLevel coarser_level(const RingLevel& fine, int ring_count) {
    return averaged_level(ring_count, 4 * ring_count, fine.ring_count, [&](int y) {
        const RingLevel::Ring& ring = fine.rings[size_t(y) + 1];
        return FineRow{fine.texels.data() + 4 * size_t(ring.first), int(ring.texel_count)};
    });
}

}  // namespace

double RingLevel::solid_angle() const {
    double count = 0;
    for (int i = 0; i < ring_count; ++i) count += double(rings[size_t(i) + 1].texel_count);
    return 4 * pi / count;
}

RingPyramid ring_pyramid(const Environment& environment) {
    RingPyramid pyramid;
    pyramid.levels.push_back(level_of_environment(environment));
    for (int halving = 1;; ++halving) {
        const int rings = int(std::lround(environment.height() * std::exp2(-0.5 * halving)));
        if (rings < 2) break;
        // From the level one octave finer where there is one, so that few averages are chained.
        const RingLevel& fine = pyramid.levels[size_t(std::max(0, halving - 2))];
        if (rings < pyramid.levels.back().ring_count)
            pyramid.levels.push_back(coarser_level(fine, rings));
        else
            break;
    }
    return pyramid;
}

Vec3 radiance_towards(const RingLevel& level, const Vec3d& direction) {
    const LatLong at = lat_long_towards(direction);
    const double y = at.v * level.ring_count - 0.5;
    const int ring = int(std::floor(y));
    const auto towards = [&](const RingLevel::Ring& r) {
        const double x = at.u * double(r.texel_count) - 0.5;
        const int column = int(std::floor(x));
        const float* texel = level.texels.data() + 4 * (int64_t(r.first) + column);
        const double t = x - column;
        return (1 - t) * Vec3d(texel[0], texel[1], texel[2]) +
               t * Vec3d(texel[4], texel[5], texel[6]);
    };
    const double t = y - ring;
    return Vec3((1 - t) * towards(level.rings[size_t(ring + 1)]) +
                t * towards(level.rings[size_t(ring + 2)]));
}

Vec3d mean_radiance(const RingLevel& level) {
    Vec3d sum(0);
    for (int i = 0; i < level.ring_count; ++i) {
        const RingLevel::Ring& ring = level.rings[size_t(i) + 1];
        Vec3d row(0);
        for (int x = 0; x < int(ring.texel_count); ++x) {
            const float* texel = level.texels.data() + 4 * (size_t(ring.first) + size_t(x));
            row += Vec3d(texel[0], texel[1], texel[2]);
        }
        sum += row * zone_height(double(i) / level.ring_count, double(i + 1) / level.ring_count) /
               double(ring.texel_count);
    }
    return 0.5 * sum;
}

}  // namespace splitsum
