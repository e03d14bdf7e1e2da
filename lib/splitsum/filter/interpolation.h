#pragma once

#include <span>

#include "splitsum/filter/sphere_grid.h"
#include "splitsum/math/vec.h"

namespace splitsum {

/// out[i] = the grid's function towards the unit direction towards[i], by Lagrange's polynomial
/// through 6 x 6 points. The place on the grid is found in fp64, the polynomial in fp32 (error 1e-6
/// of the largest of the 36 points). Cost: about 20 ns a direction.
void interpolate(const SphereGrid& grid, std::span<const Vec3d> towards, std::span<Vec3> out);

/// The largest error of `interpolate` for a wave that turns by `angle` radians from point to point:
/// Lagrange's remainder with six points, 4.9e-3 angle⁶.
double interpolation_error(double angle);

}  // namespace splitsum
