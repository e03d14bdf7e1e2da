#pragma once

#include <array>
#include <vector>

#include "splitsum/math/vec.h"
#include "splitsum/sphere/area_geometry.h"

namespace splitsum {

/// The panorama's grid as a line of the lattice meets it, seen from the axis of the line's face.
struct AreaGrid {
    AreaGrid(int height, int columns, double axis);

    int height;
    int columns;
    double axis;  ///< in columns

    // Of the upper edge of row y, y in [0, height]; symmetric about the equator to the last bit.
    std::vector<double> cosine, sine, cotangent;
    std::vector<double> cap;             ///< 1 - cosine, summed row by row
    std::vector<double> inverse_height;  ///< 1 / (cosine of this edge - cosine of the next)

    /// Sine and cosine of the azimuth from the axis of each column's far edge, going outwards.
    std::array<std::vector<Vec2d>, 2> edges;
    std::array<double, 2> first_edge;  ///< columns from the axis to the first of them, in (0, 1]
};

/// A line of the texel lattice, in half texels: where it is `distance` away from the y axis it is
/// `rise` above the equator. It lies on a great circle: tan(latitude) = rise / distance cos(azimuth).
struct LatticeLine {
    int rise;
    int distance;
};

/// A point of the lattice, seen from the axis of a face.
struct LatticePoint {
    double offset;        ///< azimuth, in columns: a multiple of 2^-24
    double sine, cosine;  ///< of that azimuth
};

/// The points of a line `distance` half texels away from the y axis, from the middle of a face of
/// `face_size` texels outwards.
std::vector<LatticePoint> lattice_points(int distance, int face_size, int columns);

/// Walks a line through the grid, by way of lattice_points(line.distance, ...).
AreaLine walked_line(const AreaGrid& grid, const LatticeLine& line, int face_size,
                     const std::vector<LatticePoint>& points);

}  // namespace splitsum
