#include "splitsum/sphere/area_walk_detail.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "splitsum/sphere/lat_long_average_detail.h"

namespace splitsum {
namespace {

constexpr double pi = std::numbers::pi;

// Azimuths, in columns, are multiples of 2^-24: differences of them are exact, also as floats. At
// 2^28 doubles are that far apart.
double snapped(double columns) {
    constexpr double coarse = 0x1.8p28;
    return (columns + coarse) - coarse;
}

// Computed for one eighth of a turn only, so that the two lines which cross in a point agree on it.
double lattice_offset(int along, int distance, int columns) {
    if (along > distance) return 0.25 * columns - lattice_offset(distance, along, columns);
    return snapped(std::atan2(double(along), double(distance)) / (2 * pi) * columns);
}

// A point of a line.
struct Point {
    double offset;        // from the axis, in columns
    double sine, cosine;  // of that azimuth
    double height;        // the cosine of the polar angle
    double descent;       // - d height / d azimuth
};

// Follows one half of a line from column to column, from row to row and from texel to texel.
class ArcWalk {
public:
    ArcWalk(const AreaGrid& grid, const LatticeLine& line, int face_size, int side, AreaLine& out)
        : grid_(grid),
          face_size_(face_size),
          side_(side),
          slope_(double(line.rise) / line.distance),
          inverse_slope_(double(line.distance) / line.rise),
          radians_per_column_(2 * pi / grid.columns),
          out_(out),
          arc_(out.arcs[size_t(side)]) {}

    void walk(const std::vector<LatticePoint>& points) {
        const size_t guess =
            points.size() + size_t(points.back().offset) + size_t(grid_.height) / 8;
        arc_.nodes.reserve(guess);
        arc_.runs.reserve(guess);
        Point from = point_at(0, 0, 1);
        row_ = first_row(from.height);
        column_ = grid_.columns + int(side_ ? std::floor(grid_.axis) : std::ceil(grid_.axis) - 1);
        size_t crossed = 0;
        const std::vector<Vec2d>& edges = grid_.edges[size_t(side_)];
        texel_ = side_ ? face_size_ / 2 : (face_size_ - 1) / 2;
        for (const LatticePoint& point : points) {
            const Point corner = point_at(point.offset, point.sine, point.cosine);
            for (;;) {
                const double edge = grid_.first_edge[size_t(side_)] + double(crossed);
                if (edge > corner.offset) break;
                const Point to = point_at(edge, edges[crossed].x, edges[crossed].y);
                go_through_rows(from, to);
                from = to;
                column_ += side_ ? 1 : -1;
                ++crossed;
            }
            go_through_rows(from, corner);
            from = corner;
            texel_ += side_ ? 1 : -1;
        }
    }

private:
    Point point_at(double offset, double sine, double cosine) const {
        const double tangent = slope_ * cosine;  // of the latitude
        const double polar_sine = 1 / std::sqrt(1 + tangent * tangent);
        return {offset, sine, cosine, tangent * polar_sine,
                slope_ * sine * polar_sine * polar_sine * polar_sine};
    }

    int first_row(double height) const {
        const auto below = std::ranges::lower_bound(grid_.cosine, height, std::greater());
        return std::max(int(below - grid_.cosine.begin()) - 1, 0);
    }

    // Where the line leaves the row, between two points of one column. sin(b - a) is a product of
    // what is known of both azimuths, and small: two terms of the arc sine are enough.
    Point row_crossing(const Point& from, const Point& to) const {
        const size_t y = size_t(row_) + 1;
        const double cosine = grid_.cotangent[y] * inverse_slope_;
        const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
        const double s = sine * from.cosine - cosine * from.sine;
        const double columns = s * (1 + s * s / 6) / radians_per_column_;
        return {std::clamp(snapped(from.offset + columns), from.offset, to.offset), sine, cosine,
                grid_.cosine[y], slope_ * sine * grid_.sine[y] * grid_.sine[y] * grid_.sine[y]};
    }

    void go_through_rows(Point from, const Point& to) {
        while (to.height < grid_.cosine[size_t(row_) + 1]) {
            const Point crossing = row_crossing(from, to);
            add_node(from, crossing);
            from = crossing;
            ++row_;
        }
        add_node(from, to);
    }

    // The mean height by the trapezoidal rule with its first correction (Euler-Maclaurin): to
    // fourth order in the azimuth covered.
    void add_node(const Point& from, const Point& to) {
        const double weight = to.offset - from.offset;
        if (weight <= 0) return;
        const double mean = 0.5 * (from.height + to.height) +
                            weight * radians_per_column_ * (to.descent - from.descent) / 12;
        const size_t y = size_t(row_);
        const double below = (grid_.cosine[y] - mean) * grid_.inverse_height[y];
        const auto fraction = uint32_t(std::clamp(below, 0.0, 1.0) * AreaNode::whole_row + 0.5);
        continue_run();
        arc_.nodes.push_back({fraction, float(weight)});
        arc_.runs.back().end = uint32_t(arc_.nodes.size());
        const double zone = grid_.cap[y + 1] - grid_.cap[y];
        const double cap = grid_.cap[y] + fraction / AreaNode::whole_row * zone;
        out_.from_above[size_t(texel_)] += weight * cap;
        out_.from_below[size_t(texel_)] += weight * (2 - cap);
    }

    void continue_run() {
        const int quarter_width = grid_.columns / 4;
        const int quarter = column_ / quarter_width % 4;
        if (!arc_.runs.empty()) {
            const AreaRun& last = arc_.runs.back();
            if (int(last.row) == row_ && last.texel == texel_ && last.quarter == quarter) return;
        }
        arc_.runs.push_back({uint32_t(row_), 0, uint32_t(column_ % quarter_width), uint16_t(texel_),
                             uint8_t(quarter)});
    }

    const AreaGrid& grid_;
    int face_size_;
    int side_;  // 0 towards smaller azimuths, 1 towards larger
    double slope_, inverse_slope_;
    double radians_per_column_;
    AreaLine& out_;
    AreaArc& arc_;
    int row_ = 0;
    int column_ = 0;  // plus a whole turn, so that it is never negative
    int texel_ = 0;
};

}  // namespace

AreaGrid::AreaGrid(int height_, int columns_, double axis_)
    : height(height_), columns(columns_), axis(axis_) {
    cap.push_back(0);
    for (int y = 0; y <= height; ++y) {
        // From the nearer pole, so that the halves mirror each other.
        const double polar = pi * std::min(y, height - y) / height;
        const double c = 2 * y == height ? 0 : std::cos(polar);
        cosine.push_back(2 * y <= height ? c : -c);
        sine.push_back(std::sin(polar));
        cotangent.push_back(cosine.back() / sine.back());
        if (y < height)
            cap.push_back(cap.back() + zone_height(double(y) / height, double(y + 1) / height));
    }
    for (size_t y = 0; y < size_t(height); ++y)
        inverse_height.push_back(1 / (cosine[y] - cosine[y + 1]));
    first_edge = {axis - (std::ceil(axis) - 1), std::floor(axis) + 1 - axis};
    for (size_t side = 0; side < 2; ++side)
        for (int i = 0; i <= columns / 4; ++i) {
            const double azimuth = 2 * pi * (first_edge[side] + i) / columns;
            edges[side].push_back({std::sin(azimuth), std::cos(azimuth)});
        }
}

std::vector<LatticePoint> lattice_points(int distance, int face_size, int columns) {
    std::vector<LatticePoint> points;
    for (int along = 2 - face_size % 2; along <= face_size; along += 2) {
        const double away = std::sqrt(double(along) * along + double(distance) * distance);
        points.push_back({lattice_offset(along, distance, columns), along / away, distance / away});
    }
    return points;
}

AreaLine walked_line(const AreaGrid& grid, const LatticeLine& line, int face_size,
                     const std::vector<LatticePoint>& points) {
    AreaLine walked;
    walked.from_above.resize(size_t(face_size));
    walked.from_below.resize(size_t(face_size));
    for (int side = 0; side < 2; ++side) {
        ArcWalk(grid, line, face_size, side, walked).walk(points);
        walked.arcs[size_t(side)].runs.shrink_to_fit();
        walked.arcs[size_t(side)].nodes.shrink_to_fit();
    }
    return walked;
}

}  // namespace splitsum
