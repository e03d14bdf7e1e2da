#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "splitsum/math/vec.h"

namespace splitsum {

/// A stretch of a lattice line inside one texel of the panorama, where F of area_filter.h is linear
/// in the height (the cosine of the polar angle): F at the mean height is the mean of F.
struct AreaNode {
    /// Where the mean height lies in the row: 0 at its upper edge, whole_row at its lower.
    uint32_t below;
    /// The azimuth covered, in columns: a multiple of 2^-24, so that sums are exact.
    float weight;

    static constexpr double whole_row = 0x1p31;
};

/// Consecutive nodes on one texel's edge, in one row and in neighbouring columns.
struct AreaRun {
    uint32_t row;
    uint32_t end;     ///< one past its last node; its first is the end of the run before
    uint32_t column;  ///< of its first node, within the quarter
    uint16_t texel;   ///< whose edge it is, counted along the line
    uint8_t quarter;  ///< of the panorama
};

/// Half of a line, from the middle outwards: rows never decrease.
struct AreaArc {
    std::vector<AreaRun> runs;
    std::vector<AreaNode> nodes;
};

/// One line of the lattice and the solid angle between each of its edges and either pole, in
/// columns times height, by the same nodes.
struct AreaLine {
    std::array<AreaArc, 2> arcs;     ///< towards smaller and towards larger azimuths
    std::vector<double> from_above;  ///< [texel]
    std::vector<double> from_below;
};

/// Where the lines of a cube's texel lattice run through the texels of a panorama: all that
/// area_filter.h has to know of the two grids. It depends on sizes and on the turn alone and never
/// changes, so one serves all panoramas of a size, also at the same time.
///
/// A cube face is like the next one a quarter turn about y further, and like its mirror image below
/// the equator. So one line stands for eight: the lines of half a side face, and those of a quarter
/// of a polar face. The panorama's columns are cut into equal parts until a quarter turn is a whole
/// number of them and they are narrow; from here on "columns" are these parts.
///
/// Memory: 8 bytes for each piece that columns, rows and texels cut a line into and 16 for each run
/// of them. For 16384 x 8192 texels: 21 MB for faces of 256 texels, 47 MB for 512.
class AreaGeometry {
public:
    /// `panorama_from_cube` must turn about y only, perhaps after mirroring (sphere/orientation.h
    /// makes such matrices).
    AreaGeometry(int height, int face_size, const Mat3d& panorama_from_cube);

    int height() const { return height_; }
    int face_size() const { return face_size_; }

    /// The number of parts that each column of the panorama is cut into.
    int parts() const { return parts_; }
    int columns_per_quarter() const { return height_ * parts_ / 2; }

    /// True where the panorama must be mirrored first: its rows be read from right to left.
    bool mirrored() const { return mirrored_; }
    /// The panorama's column, after that, with which the first quarter begins: the face towards +Z
    /// lies in this quarter. Other columns are counted from this one.
    int first_column() const { return first_column_; }
    /// The column at azimuth 0 of the cube (+Z), a multiple of 2^-24.
    double axis() const { return axis_; }

    /// The lines of the upper half, `face_size` of them. Theirs is the side face towards +Z, and
    /// the parts of the polar face on the same side of the pole.
    const std::vector<AreaLine>& lines() const { return lines_; }

    /// The line above texel row `j` of the side face, j <= face_size / 2: of the equator if
    /// j = face_size / 2.
    static int side_line(int j) { return j; }
    /// The line `j` texels inside the polar face, j < face_size / 2 rounded up; the cube's edge, and
    /// therefore the line of the side face, if j = 0.
    int polar_line(int j) const { return j == 0 ? 0 : face_size_ / 2 + j; }

private:
    int height_;
    int face_size_;
    int parts_;
    bool mirrored_;
    int first_column_;
    double axis_;
    std::vector<AreaLine> lines_;
};

}  // namespace splitsum
