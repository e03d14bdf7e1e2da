#include "splitsum/sphere/area_geometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/base/parallel.h"
#include "splitsum/sphere/area_walk_detail.h"

namespace splitsum {
namespace {

// Narrow enough that a line's height is known to 1e-8 of itself between two of their edges.
constexpr int fewest_columns = 1024;

int parts_of_column(int width) {
    int parts = (fewest_columns + width - 1) / width;
    while (width * parts % 4 != 0) ++parts;
    return parts;
}

}  // namespace

AreaGeometry::AreaGeometry(int height, int face_size, const Mat3d& panorama_from_cube)
    : height_(height),
      face_size_(face_size),
      parts_(parts_of_column(2 * height)),
      lines_(size_t(face_size)) {
    const Vec3d right = panorama_from_cube[0], ahead = panorama_from_cube[2];
    mirrored_ = right.x * ahead.z - right.z * ahead.x < 0;
    const double azimuth = std::atan2(mirrored_ ? -ahead.x : ahead.x, ahead.z);
    const int columns = 4 * columns_per_quarter();
    const double ahead_column = (azimuth / (2 * std::numbers::pi) + 0.5) * columns;
    const int skipped = int(std::floor(ahead_column)) - columns_per_quarter() / 2;
    first_column_ = (skipped + columns) % columns;
    axis_ = std::round((ahead_column - skipped) * 0x1p24) * 0x1p-24;

    const AreaGrid grid(height, columns, axis_);
    const auto walk = [&](int index, const LatticeLine& line, const auto& points) {
        lines_[size_t(index)] = walked_line(grid, line, face_size, points);
    };
    const auto side_points = lattice_points(face_size, face_size, columns);
    parallel_rows(face_size / 2 + 1, [&](int j) {
        walk(side_line(j), {face_size - 2 * j, face_size}, side_points);
    });
    parallel_rows((face_size - 1) / 2, [&](int i) {
        const int distance = face_size - 2 * (i + 1);
        walk(polar_line(i + 1), {face_size, distance},
             lattice_points(distance, face_size, columns));
    });
}

}  // namespace splitsum
