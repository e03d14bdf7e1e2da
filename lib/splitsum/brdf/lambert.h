#pragma once

#include "splitsum/math/vec.h"

namespace splitsum {

// Directions around +z in proportion to their cosine: what a diffuse surface gathers.
// Malley's method; e.g. Pharr, Jakob & Humphreys 2023, "Physically Based Rendering", A.5.3.

/// Probability per steradian with which sample_cosine_direction returns a direction at this cosine
/// from +z: cos theta / pi, and 0 below the horizon.
double cosine_direction_pdf(double cos_theta);

/// Maps u in [0, 1)² to a unit direction with density cosine_direction_pdf: sin² theta = u.x, and
/// u.y sets the azimuth.
Vec3d sample_cosine_direction(const Vec2d& u);

}  // namespace splitsum
