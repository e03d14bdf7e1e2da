#pragma once

#include <span>

#include "splitsum/image/table.h"
#include "splitsum/math/vec.h"
#include "splitsum/plan/table_plan.h"
#include "splitsum/table/grid.h"

namespace splitsum {

/// What a sampler with a linear filter and clamp-to-edge returns at texture coordinates in [0, 1]
/// (texel centres at (i + 1/2) / size, whatever the layout means): channel after channel, layer
/// after layer into `read`, which holds channels * layers numbers. The filter itself is exact here;
/// hardware blends in steps of 1/256.
void read_bilinear(const Table& table, const Vec2d& coordinates, std::span<double> read);

/// Where a renderer samples the arranged table of `plan` (of `size` texels along an edge) for a view
/// and a roughness in [0, 1], which are clamped. The GLSL twins are in
/// shaders/include/splitsum_split_sum.glsl.
Vec2d texture_coordinates(const TablePlan& plan, int size, ViewAxis view_axis, double n_dot_v,
                          double perceptual_roughness);

}  // namespace splitsum
