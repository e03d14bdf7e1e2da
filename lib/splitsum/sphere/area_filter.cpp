#include "splitsum/sphere/area_filter.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>

#include "splitsum/base/parallel.h"

namespace splitsum {
namespace {

constexpr double pi = std::numbers::pi;

// Radiance and solid angle integrated together, so that their ratio is a mean: the fourth
// component is the integral of 1.
using Sum = glm::dvec4;

// F of area_filter.h, measured from the pole that is nearer: from +Y on the upper half of the
// cube and from -Y (with a negative sign) on the lower face, so that it vanishes at that pole.
class ColumnSums {
public:
    explicit ColumnSums(const Environment& environment)
        : width_(environment.width()),
          height_(environment.height()),
          sums_(static_cast<size_t>(width_) * static_cast<size_t>(height_ + 1)),
          environment_(environment) {
        for (int y = 0; y <= height_; ++y) boundary_cosines_.push_back(std::cos(pi * y / height_));
        constexpr int block = 64;  // columns; a row of a block is a few cache lines
        parallel_rows((width_ + block - 1) / block, [&](int b) {
            const int end = std::min(width_, (b + 1) * block);
            for (int y = 0; y < height_; ++y) {
                const double weight = solid_angle_of_row(y, height_) * width_ / (2 * pi);
                for (int x = b * block; x < end; ++x)
                    at(x, y + 1) = at(x, y) + weight * Vec3d(environment.texel(x, y));
            }
        });
    }

    int width() const { return width_; }

    Sum from_top(int x, double theta) const {
        const int y = std::clamp(int(theta / pi * height_), 0, height_ - 1);
        const double cosine = std::cos(theta);
        return Sum(at(x, y) + (boundary_cosines_[size_t(y)] - cosine) *
                                  Vec3d(environment_.texel(x, y)),
                   1 - cosine);
    }

    Sum from_bottom(int x, double theta) const {
        return from_top(x, theta) - Sum(at(x, height_), 2.0);
    }

private:
    Vec3d& at(int x, int y) { return sums_[size_t(y) * size_t(width_) + size_t(x)]; }
    const Vec3d& at(int x, int y) const { return sums_[size_t(y) * size_t(width_) + size_t(x)]; }

    int width_;
    int height_;
    std::vector<Vec3d> sums_;  // sums_[y][x]: rows 0 .. y - 1 of column x
    std::vector<double> boundary_cosines_;
    const Environment& environment_;
};

// An edge of the texel lattice of one face: a straight line on the cube, part of a great circle,
// given by its azimuths and the polar angle at each azimuth: cot(theta) = slope cos(phi - peak).
struct Edge {
    double from;
    double to;
    double slope;
    double peak;

    double theta(double azimuth) const {
        return std::atan2(1.0, slope * std::cos(azimuth - peak));
    }
};

Edge edge_between(const Vec3d& a, const Vec3d& b) {
    const double from = std::atan2(a.x, a.z);
    const double to = from + std::remainder(std::atan2(b.x, b.z) - from, 2 * pi);
    // The plane through both directions is n·d = 0, so cot(theta) = -(n.x sin + n.z cos) / n.y.
    const Vec3d n = cross(a, b);
    return {from, to, -std::hypot(n.x, n.z) / n.y, std::atan2(n.x, n.z)};
}

// Radians of azimuth over which two Gauss points follow an edge to 1e-9.
constexpr double longest_piece = 0.02;

// The contour integral of F along an edge.
Sum integral_along(const Edge& edge, const ColumnSums& sums, bool lower_half) {
    constexpr double gauss = 0.28867513459481288;  // 1 / (2 sqrt 3)
    const double columns_per_radian = sums.width() / (2 * pi);
    const double direction = edge.to > edge.from ? 1 : -1;
    const double low = std::min(edge.from, edge.to) * columns_per_radian + 0.5 * sums.width();
    const double high = std::max(edge.from, edge.to) * columns_per_radian + 0.5 * sums.width();

    const double longest = longest_piece * columns_per_radian;
    Sum total(0);
    for (double start = low; start < high;) {
        const double column = std::floor(start);
        const double end = std::min({high, column + 1, start + longest});
        const int wrapped = int(std::fmod(std::fmod(column, sums.width()) + sums.width(), sums.width()));
        for (const double node : {0.5 - gauss, 0.5 + gauss}) {
            const double azimuth =
                (start + node * (end - start) - 0.5 * sums.width()) / columns_per_radian;
            const double theta = edge.theta(azimuth);
            total += 0.5 * (end - start) *
                     (lower_half ? sums.from_bottom(wrapped, theta) : sums.from_top(wrapped, theta));
        }
        start = end;
    }
    return direction * total;
}

// The integrals over one row of texels of a face: the edges above and below, and those between.
void filter_row(int face, int y, int face_size, const Mat3d& panorama_from_cube,
                const ColumnSums& sums, std::span<Vec3> row) {
    const bool lower_half = face == 3;
    const auto corner = [&](int i, int j) {
        return panorama_from_cube *
               direction_on_face(face, double(i) / face_size, double(j) / face_size);
    };
    const auto edge = [&](const Vec3d& a, const Vec3d& b) {
        // Meridians, among them the edges that end at a pole, contribute nothing.
        if (std::abs(cross(a, b).y) < 1e-14) return Sum(0);
        return integral_along(edge_between(a, b), sums, lower_half);
    };
    const bool polar = face == 2 || face == 3;  // elsewhere the edges between are meridians
    Sum left = polar ? edge(corner(0, y), corner(0, y + 1)) : Sum(0);
    for (int x = 0; x < face_size; ++x) {
        const Sum right = polar ? edge(corner(x + 1, y), corner(x + 1, y + 1)) : Sum(0);
        const Sum texel = edge(corner(x, y), corner(x + 1, y)) + right -
                          edge(corner(x, y + 1), corner(x + 1, y + 1)) - left;
        row[size_t(x)] = Vec3(Vec3d(texel) / texel.w);
        left = right;
    }
}

}  // namespace

Result<Cubemap> area_filtered_cubemap(const Environment& environment, int face_size,
                                      const Mat3d& panorama_from_cube, Progress& progress) {
    const ColumnSums sums(environment);
    Cubemap cubemap(face_size);
    parallel_rows(face_count * face_size, [&](int i) {
        if (progress.cancelled()) return;
        const int face = i / face_size, y = i % face_size;
        filter_row(face, y, face_size, panorama_from_cube, sums, cubemap.row(face, y));
        progress.advance(1);
    });
    if (progress.cancelled()) return Error{ErrorKind::interrupted, "interrupted in the mirror level"};
    return cubemap;
}

}  // namespace splitsum
