#pragma once

#include "splitsum/math/vec.h"

namespace splitsum {

// The GGX normals that a viewer sees: those turned away, or hidden by other facets, are left out in
// proportion. Heitz 2018, "Sampling the GGX Distribution of Visible Normals", JCGT 7(4).

/// Probability per steradian with which sample_visible_normal returns `normal` (eq. 3):
///     G1(v) max(v·h, 0) D(h) / v.z,   0 below the surface.
/// `view` is a unit vector with z > 0; `alpha` in (0, 1].
double visible_normal_pdf(const Vec3d& view, const Vec3d& normal, double alpha);

/// Maps u in [0, 1)² to a unit normal with density visible_normal_pdf by a spherical cap around the
/// stretched view (Dupuy & Benyoub 2023, "Sampling Visible GGX Normals with Spherical Caps", HPG):
/// u.x sets the height on the cap, u.y the azimuth. `alpha` in [0, 1]; 0 gives +z.
Vec3d sample_visible_normal(const Vec3d& view, const Vec2d& u, double alpha);

}  // namespace splitsum
