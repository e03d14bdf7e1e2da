#include "splitsum/sphere/environment.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/base/parallel.h"
#include "splitsum/sphere/environment_builder.h"
#include "splitsum/sphere/lat_long_average_detail.h"

namespace splitsum {
namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

Environment::Environment(int height)
    : height_(height), texels_(8 * static_cast<size_t>(height) * static_cast<size_t>(height)) {}

Environment::Environment(const Image& panorama) : Environment(panorama.height) {
    parallel_rows(height_, [&](int y) {
        const auto row = panorama.row(y);
        float* texel = texels_.data() + index_of(0, y);
        for (size_t i = 0; i < row.size(); i += 3, texel += 4) std::copy_n(&row[i], 3, texel);
    });
}

double solid_angle_of_row(int y, int height) {
    return pi / height * zone_height(double(y) / height, double(y + 1) / height);
}

Vec3d direction_of_lat_long(double u, double v) {
    const double azimuth = 2 * pi * (u - 0.5);
    const double sine = std::sin(pi * v);
    return {sine * std::sin(azimuth), std::cos(pi * v), sine * std::cos(azimuth)};
}

LatLong lat_long_towards(const Vec3d& d) {
    return {0.5 + std::atan2(d.x, d.z) / (2 * pi), std::atan2(std::hypot(d.x, d.z), d.y) / pi};
}

Vec3 radiance_towards(const Environment& environment, const Vec3d& direction) {
    const LatLong at = lat_long_towards(direction);
    const int x = std::min(int(at.u * environment.width()), environment.width() - 1);
    const int y = std::min(int(at.v * environment.height()), environment.height() - 1);
    return environment.texel(x, y);
}

Vec3d mean_radiance(const Environment& environment) {
    const Vec3d sum = ordered_sum(environment.height(), [&](int y) {
        Vec3d row(0);
        for (int x = 0; x < environment.width(); ++x) row += Vec3d(environment.texel(x, y));
        return row * solid_angle_of_row(y, environment.height());
    });
    return sum / (4 * pi);
}

Environment averaged_down(const Environment& environment, int height) {
    EnvironmentBuilder builder(environment.height(), height);
    builder.add_rows(environment.height(), environment.texels().data(), 4);
    return std::move(builder).finish();
}

}  // namespace splitsum
