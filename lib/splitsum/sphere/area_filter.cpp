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

// F of area_filter.h, from the pole at +Y down.
class ColumnSums {
public:
    explicit ColumnSums(const Environment& environment)
        : width_(environment.width()),
          height_(environment.height()),
          sums_(size_t(width_) * size_t(height_ + 1)),
          environment_(environment) {
        for (int y = 0; y <= height_; ++y) boundary_cosines_.push_back(std::cos(pi * y / height_));
        for (int x = 0; x < width_; ++x) {
            boundary_sin_.push_back(std::sin(2 * pi * x / width_ - pi));
            boundary_cos_.push_back(std::cos(2 * pi * x / width_ - pi));
        }
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
    int height() const { return height_; }

    // The direction of the left edge of column x, as the sine and cosine of its azimuth.
    double boundary_sin(int x) const { return boundary_sin_[size_t(x)]; }
    double boundary_cos(int x) const { return boundary_cos_[size_t(x)]; }

    // The row that holds this cosine of the polar angle, found by walking from `row`.
    int row_of(double cosine, int row) const {
        while (row > 0 && cosine > boundary_cosines_[size_t(row)]) --row;
        while (row + 1 < height_ && cosine < boundary_cosines_[size_t(row) + 1]) ++row;
        return row;
    }

    Sum from_top(int x, int row, double cosine) const {
        return Sum(at(x, row) + (boundary_cosines_[size_t(row)] - cosine) *
                                    Vec3d(environment_.texel(x, row)),
                   1 - cosine);
    }

    Sum whole_column(int x) const { return Sum(at(x, height_), 2.0); }

private:
    Vec3d& at(int x, int y) { return sums_[size_t(y) * size_t(width_) + size_t(x)]; }
    const Vec3d& at(int x, int y) const { return sums_[size_t(y) * size_t(width_) + size_t(x)]; }

    int width_;
    int height_;
    std::vector<Vec3d> sums_;  // sums_[y][x]: rows 0 .. y - 1 of column x
    std::vector<double> boundary_cosines_;
    std::vector<double> boundary_sin_, boundary_cos_;
    const Environment& environment_;
};

// A line of the texel lattice on a face of the cube: from + t * step for t in [0, texels].
struct Line {
    Vec3d from;
    Vec3d step;
    int texels;
};

// Radians of azimuth over which one point in the middle, and two Gauss points, follow a line to
// 3e-6 and 1e-9 of a texel.
constexpr double short_piece = 0.008;
constexpr double longest_piece = 0.02;

// Walks along a line from column to column of the panorama and integrates F dphi over each texel's
// edge. The azimuth is atan2(x, z), so along the line dphi = (z dx - x dz) / (x² + z²), whose
// numerator does not change.
class LineWalk {
public:
    LineWalk(const Line& line, const ColumnSums& sums, bool from_bottom)
        : line_(line),
          sums_(sums),
          from_bottom_(from_bottom),
          turn_(line.from.z * line.step.x - line.from.x * line.step.z) {}

    void integrate(std::span<Sum> edges) {
        std::ranges::fill(edges, Sum(0));
        // Meridians, among them the lines through a pole, contribute nothing.
        if (std::abs(turn_) < 1e-14) return;
        start();
        double t = 0;
        for (int texel = 0; texel < line_.texels; ++texel)
            while (t < texel + 1) {
                const double end = std::min(texel + 1.0, next_column_);
                edges[size_t(texel)] += piece(t, end);
                t = end;
                if (t >= next_column_) enter_next_column();
            }
    }

private:
    Vec3d at(double t) const { return line_.from + t * line_.step; }

    void start() {
        // Half a step of rounding further on, so that a line that starts on a boundary is on the
        // side towards which it goes.
        const double nudge = (turn_ > 0 ? 1e-12 : -1e-12);
        const double azimuth = std::atan2(line_.from.x, line_.from.z) + nudge;
        column_ = wrapped(int(std::floor((azimuth / (2 * pi) + 0.5) * sums_.width())));
        row_ = sums_.height() / 2;
        next_column_ = boundary_ahead();
    }

    int wrapped(int column) const { return (column + sums_.width()) % sums_.width(); }

    void enter_next_column() {
        column_ = wrapped(column_ + (turn_ > 0 ? 1 : -1));
        next_column_ = boundary_ahead();
    }

    // Where the line meets the meridian on which its column ends; beyond the line if it does not.
    double boundary_ahead() const {
        const int boundary = turn_ > 0 ? wrapped(column_ + 1) : column_;
        const double sine = sums_.boundary_sin(boundary), cosine = sums_.boundary_cos(boundary);
        const double t = (line_.from.z * sine - line_.from.x * cosine) /
                         (line_.step.x * cosine - line_.step.z * sine);
        const Vec3d meets = at(t);
        const bool ahead = meets.x * sine + meets.z * cosine > 0;  // not the opposite meridian
        return ahead && t > 0 ? t : line_.texels + 1.0;
    }

    // A stretch of the line within one column and one texel, in equal parts: the same ones for the
    // face on the other side of a cube edge, which walks the other way.
    Sum piece(double from, double to) {
        constexpr double gauss = 0.28867513459481288;  // 1 / (2 sqrt 3)
        const Vec3d middle = at(0.5 * (from + to));
        const double azimuths =
            std::abs(turn_) * (to - from) / (middle.x * middle.x + middle.z * middle.z);
        if (azimuths < short_piece) return node(0.5 * (from + to), to - from);
        const int parts = 1 + int(azimuths / longest_piece);
        const double length = (to - from) / parts;
        Sum sum(0);
        for (int i = 0; i < parts; ++i)
            for (const double place : {i + 0.5 - gauss, i + 0.5 + gauss})
                sum += node(from + place * length, 0.5 * length);
        return sum;
    }

    // F dphi at a point of the line that stands for `length` of it.
    Sum node(double t, double length) {
        const Vec3d p = at(t);
        const double horizontal2 = p.x * p.x + p.z * p.z;
        const double cosine = p.y / std::sqrt(horizontal2 + p.y * p.y);
        row_ = sums_.row_of(cosine, row_);
        Sum f = sums_.from_top(column_, row_, cosine);
        if (from_bottom_) f -= sums_.whole_column(column_);
        return length * turn_ / horizontal2 * f;
    }

    const Line& line_;
    const ColumnSums& sums_;
    bool from_bottom_;  // the lower face: F must vanish at the pole inside it
    double turn_;
    int column_ = 0;
    int row_ = 0;
    double next_column_ = 0;
};

// The integrals along all edges of the lattice of one face.
struct EdgeIntegrals {
    std::vector<Sum> across;  // [line][texel]: line j lies above texel row j
    std::vector<Sum> down;    // [line][texel]: line i lies left of texel column i; empty if all 0
};

struct FaceFrame {
    Vec3d corner, right, down;  // the upper left corner and the way to the others, in the panorama

    FaceFrame(int face, const Mat3d& panorama_from_cube) {
        const auto on_plane = [&](double s, double t) {  // on the plane at distance 1
            const Vec3d d = direction_on_face(face, s, t);
            return panorama_from_cube *
                   (d / std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}));
        };
        corner = on_plane(0, 0);
        right = on_plane(1, 0) - corner;
        down = on_plane(0, 1) - corner;
    }
};

EdgeIntegrals integrate_edges(int face, int face_size, const Mat3d& panorama_from_cube,
                              const ColumnSums& sums) {
    const FaceFrame frame(face, panorama_from_cube);
    const bool polar = face == 2 || face == 3;  // elsewhere the lines down are meridians
    const size_t size = size_t(face_size);
    EdgeIntegrals edges;
    edges.across.resize((size + 1) * size);
    if (polar) edges.down.resize((size + 1) * size);
    const auto integrate = [&](const Vec3d& origin, const Vec3d& to_next, const Vec3d& along, int i,
                               std::vector<Sum>& out) {
        const Line line{origin + double(i) / face_size * to_next, along / double(face_size),
                        face_size};
        LineWalk(line, sums, face == 3).integrate(std::span(out).subspan(size_t(i) * size, size));
    };
    parallel_rows(face_size + 1, [&](int i) {
        integrate(frame.corner, frame.down, frame.right, i, edges.across);
        if (polar) integrate(frame.corner, frame.right, frame.down, i, edges.down);
    });
    return edges;
}

void combine_edges(const EdgeIntegrals& edges, int face, Cubemap& cubemap) {
    const size_t size = size_t(cubemap.face_size);
    parallel_rows(cubemap.face_size, [&](int row) {
        const auto texels = cubemap.row(face, row);
        const size_t y = size_t(row);
        for (size_t x = 0; x < size; ++x) {
            Sum texel = edges.across[y * size + x] - edges.across[(y + 1) * size + x];
            if (!edges.down.empty())
                texel += edges.down[(x + 1) * size + y] - edges.down[x * size + y];
            texels[x] = Vec3(Vec3d(texel) / texel.w);
        }
    });
}

}  // namespace

Result<Cubemap> area_filtered_cubemap(const Environment& environment, int face_size,
                                      const Mat3d& panorama_from_cube, Progress& progress) {
    const ColumnSums sums(environment);
    Cubemap cubemap(face_size);
    for (int face = 0; face < face_count; ++face) {
        if (progress.cancelled())
            return Error{ErrorKind::interrupted, "interrupted in the mirror level"};
        combine_edges(integrate_edges(face, face_size, panorama_from_cube, sums), face, cubemap);
        progress.advance(face_size);
    }
    return cubemap;
}

}  // namespace splitsum
