#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "splitsum/math/vec.h"
#include "splitsum/sphere/area_geometry.h"

namespace splitsum {

/// A value at four places a quarter turn apart, going towards larger azimuths.
using FourTurns = std::array<Vec3d, 4>;

/// below[i] = above[i] + zone_height * texels, for `count` columns of a quarter: the four texels of
/// the first are at `texels`, those of the next `step` floats further on. Runs on the widest
/// instruction set of the machine; differs from the plain sum by at most one rounding.
void add_row(const FourTurns* above, FourTurns* below, size_t count,
             std::array<const float*, 4> texels, std::ptrdiff_t step, double zone_height);

/// Sums of columns at a few consecutive edges of rows, from the upper edge of the first one down.
struct AreaRows {
    const FourTurns* const* above;
    int first_row;
    int row_count;
    int height;  ///< of the panorama
    bool lower;  ///< what is filled is the mirror image of the lines
};

/// Adds the integral of F along each run of an arc that lies in these rows to its edge. `column_step`
/// is 1 or -1, `done` the number of runs in the rows before. Returns that number for the next rows.
uint32_t add_runs(const AreaArc& arc, int column_step, uint32_t done, const AreaRows& rows,
                  FourTurns* edges);

}  // namespace splitsum
