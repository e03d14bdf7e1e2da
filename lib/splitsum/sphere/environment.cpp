#include "splitsum/sphere/environment.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/base/parallel.h"

namespace splitsum {
namespace {

constexpr double pi = std::numbers::pi;

// The part of [first, first + 1) of a coarse axis that each fine cell covers.
struct Overlap {
    int cell;
    double from;  // in fine cells
    double to;
};

std::vector<Overlap> overlaps(int coarse_cell, int coarse_count, int fine_count) {
    const double from = double(coarse_cell) * fine_count / coarse_count;
    const double to = double(coarse_cell + 1) * fine_count / coarse_count;
    std::vector<Overlap> cells;
    for (int cell = int(from); cell < fine_count && cell < to; ++cell) {
        const double low = std::max(from, double(cell)), high = std::min(to, cell + 1.0);
        if (high > low) cells.push_back({cell, low, high});
    }
    return cells;
}

// cos(a) - cos(b) without cancellation.
double cosine_difference(double a, double b) {
    return 2 * std::sin(0.5 * (a + b)) * std::sin(0.5 * (b - a));
}

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
    return pi / height * cosine_difference(pi * y / height, pi * (y + 1) / height);
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

Environment averaged_down(const Environment& fine, int height) {
    Environment coarse(height);
    const double step = pi / fine.height();
    std::vector<std::vector<Overlap>> columns;
    for (int x = 0; x < coarse.width(); ++x)
        columns.push_back(overlaps(x, coarse.width(), fine.width()));

    parallel_rows(height, [&](int y) {
        std::vector<Vec3d> sums(columns.size(), Vec3d(0));
        double total = 0;
        for (const Overlap& row : overlaps(y, height, fine.height())) {
            const double weight = cosine_difference(row.from * step, row.to * step);
            total += weight;
            for (size_t x = 0; x < columns.size(); ++x)
                for (const Overlap& column : columns[x])
                    sums[x] += weight * (column.to - column.from) *
                               Vec3d(fine.texel(column.cell, row.cell));
        }
        const double columns_per_texel = double(fine.width()) / coarse.width();
        for (size_t x = 0; x < sums.size(); ++x)
            coarse.set_texel(int(x), y, Vec3(sums[x] / (total * columns_per_texel)));
    });
    return coarse;
}

}  // namespace splitsum
