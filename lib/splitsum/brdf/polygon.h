#pragma once

#include <span>
#include <vector>

#include "splitsum/math/vec.h"

namespace splitsum {

/// The part of a convex polygon above the plane z = 0 (Sutherland & Hodgman 1974, "Reentrant polygon
/// clipping", with one plane); empty when all of it lies below. Corners are points, in order, the
/// origin not on the polygon. At most one corner more than came in.
std::vector<Vec3d> clip_to_horizon(std::span<const Vec3d> polygon);

/// The share of a clamped cosine about +z that a polygon above the horizon covers, its form factor
/// E / pi, in [0, 1]:
///     1 / (2 pi) |sum over edges of (angle of the edge) (z of the unit normal of its plane)|
/// Lambert 1760; Arvo 1995, "Applications of Irradiance Tensors to the Simulation of Non-Lambertian
/// Phenomena", SIGGRAPH, eq. 2. The winding does not matter. `polygon` holds points with z >= 0 whose
/// distances do not matter; fewer than three give 0. Absolute error below 1e-14 for corners of
/// ordinary length (angles come from atan2: no cancellation at tiny edges).
double polygon_form_factor(std::span<const Vec3d> polygon);

}  // namespace splitsum
