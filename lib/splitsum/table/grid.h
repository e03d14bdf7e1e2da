#pragma once

#include <vector>

#include "splitsum/image/table.h"
#include "splitsum/plan/table_plan.h"

namespace splitsum {

/// What the n·v axis of a kind of table counts in.
enum class ViewAxis {
    cosine,                 ///< n·v
    sqrt_one_minus_cosine,  ///< sqrt(1 - n·v), finer where views are perpendicular (Heitz et al. 2016)
};

/// n·v at a coordinate in [0, 1] of such an axis.
double n_dot_v_at(ViewAxis axis, double coordinate);
/// The coordinate of n·v in [0, 1], its inverse.
double coordinate_of_n_dot_v(ViewAxis axis, double n_dot_v);

/// Perceptual roughness at a coordinate in [0, 1] of the roughness axis, and the inverse.
double perceptual_roughness_at(RoughnessAxis axis, double coordinate);
double coordinate_of_roughness(RoughnessAxis axis, double perceptual_roughness);

/// The coordinate, in [0, 1], of texel `index` of `size`.
double coordinate_of_texel(TexelLayout layout, int index, int size);

/// Where the texels of a table lie before it is arranged in a texture: canonical tables have
/// x = n·v and y = roughness, both in the order of these lists.
struct TableGrid {
    std::vector<double> n_dot_v;               ///< one a column, in [0, 1], 0 and 1 included
    std::vector<double> perceptual_roughness;  ///< one a row, ascending, in [0, 1]
};

/// The grid of a plan whose size is a number.
TableGrid grid_of(const TablePlan& plan, ViewAxis view_axis);

/// The canonical table as the plan's axes and flip want it; and the way back.
Table arranged(const Table& canonical, const TablePlan& plan);
Table canonical_of(const Table& arranged, const TablePlan& plan);

}  // namespace splitsum
