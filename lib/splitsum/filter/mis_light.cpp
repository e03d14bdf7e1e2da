#include "splitsum/filter/mis_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>

#include "splitsum/base/parallel.h"

namespace splitsum {
namespace {

constexpr double pi = std::numbers::pi;

double weight_of(const Vec3d& light) { return (light.x + light.y + light.z) / 3; }

Vec3d smallest_of_channels(const Environment& environment) {
    std::vector<Vec3> lowest(size_t(environment.height()));
    parallel_rows(environment.height(), [&](int y) {
        Vec3& row = lowest[size_t(y)];
        row = environment.texel(0, y);
        for (int x = 1; x < environment.width(); ++x) row = min(row, environment.texel(x, y));
    });
    return Vec3d(std::reduce(lowest.begin(), lowest.end(), lowest[0],
                             [](const Vec3& a, const Vec3& b) { return min(a, b); }));
}

// The interval of a distribution that a number of [0, 1) falls into, and where in it.
struct Place {
    int index;
    double within;  // [0, 1)
};

// `ends` ascend; intervals of no width are never found.
Place place_in(std::span<const double> ends, double u) {
    const double target = std::min(u * ends.back(), std::nextafter(ends.back(), 0.0));
    const auto end = std::upper_bound(ends.begin(), ends.end(), target);
    const double begin = end == ends.begin() ? 0 : *(end - 1);
    return {int(end - ends.begin()), (target - begin) / (*end - begin)};
}

}  // namespace

LightSampler::LightSampler(const Environment& environment)
    : environment_(environment),
      floor_(smallest_of_channels(environment)),
      column_ends_(size_t(environment.width()) * size_t(environment.height())),
      row_ends_(size_t(environment.height())) {
    const int width = environment.width();
    parallel_rows(environment.height(), [&](int y) {
        double* ends = column_ends_.data() + size_t(y) * size_t(width);
        double sum = 0;
        for (int x = 0; x < width; ++x) ends[x] = sum += weight_of(light_of(x, y));
        row_ends_[size_t(y)] = sum * solid_angle_of_row(y, environment.height());
    });
    std::partial_sum(row_ends_.begin(), row_ends_.end(), row_ends_.begin());
    total_ = row_ends_.back();
    for (int y = 0; y <= environment.height(); ++y)
        edge_cosines_.push_back(std::cos(pi * y / environment.height()));
}

LightSampler::Sample LightSampler::sample(const Vec2d& u) const {
    const int width = environment_.width();
    const Place row = place_in(row_ends_, u.x);
    const Place column =
        place_in({column_ends_.data() + size_t(row.index) * size_t(width), size_t(width)}, u.y);
    // Uniform in the cosine and the azimuth is uniform over the solid angle.
    const double* edge = edge_cosines_.data() + row.index;
    const double cosine = edge[0] + row.within * (edge[1] - edge[0]);
    const double sine = std::sqrt((1 - cosine) * (1 + cosine));
    const double azimuth = 2 * pi * ((column.index + column.within) / width - 0.5);
    return at(column.index, row.index,
              {sine * std::sin(azimuth), cosine, sine * std::cos(azimuth)});
}

LightSampler::Sample LightSampler::towards(const Vec3d& direction) const {
    const LatLong place = lat_long_towards(direction);
    const int x = std::min(int(place.u * environment_.width()), environment_.width() - 1);
    const int y = std::min(int(place.v * environment_.height()), environment_.height() - 1);
    return at(x, y, direction);
}

LightSampler::Sample LightSampler::at(int x, int y, const Vec3d& direction) const {
    const Vec3d light = light_of(x, y);
    return {direction, light, is_flat() ? 0 : weight_of(light) / total_};
}

}  // namespace splitsum
