#pragma once

#include "splitsum/math/vec.h"

namespace splitsum {

// GGX / Trowbridge-Reitz distribution of microfacet normals around +z. Walter et al. 2007,
// "Microfacet Models for Refraction through Rough Surfaces", EGSR, eq. 33, 35 and 36.
//
// Everything takes and returns sin² theta: narrow distributions live where cos theta rounds to 1,
// and 1 - cos² has lost every digit there (in fp32 88 % of the density at perceptual roughness
// 0.02). `alpha` is the width of the distribution, perceptual roughness squared.

/// D per steradian at the angle theta from the surface's normal; D cos theta integrates to 1 over
/// the hemisphere. `alpha` in (0, 1], `sin2_theta` in [0, 1].
double ggx_density(double sin2_theta, double alpha);

/// Probability per steradian with which sample_ggx_normal returns the unit vector `normal`:
/// D cos theta, and 0 below the surface. `alpha` in (0, 1].
double ggx_normal_pdf(const Vec3d& normal, double alpha);

/// A unit microfacet normal and the square of its sine, which `normal` alone could not give back.
struct GgxNormal {
    Vec3d normal;
    double sin2_theta;
};

/// Maps u in [0, 1)² to a microfacet normal with density ggx_normal_pdf: u.x sets the angle by
/// tan² theta = alpha² u.x / (1 - u.x), u.y the azimuth. `alpha` in [0, 1]; 0 gives +z.
GgxNormal sample_ggx_normal(const Vec2d& u, double alpha);

}  // namespace splitsum
