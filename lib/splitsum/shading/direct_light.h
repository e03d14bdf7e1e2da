#pragma once

#include "splitsum/math/vec.h"

namespace splitsum {

// Light from one direction, such as the sun when it has been taken out of the panorama: the twin of
// shaders/include/splitsum_direct_light.glsl. The BRDF is that of the tables: GGX,
// height-correlated Smith, Schlick's Fresnel. Unit vectors in one frame, all from the surface away.
//
// What is returned is BRDF times n·l: times the illuminance across the light's direction (lux where
// radiance is in cd/m²) it is the radiance towards the viewer. 0 for light from behind.

/// Diffuse light of an albedo of 1: n·l / pi.
double direct_diffuse(const Vec3d& normal, const Vec3d& towards_light);

/// D V F n·l of a GGX surface, per channel of `f0`. `alpha2` in (0, 1] is the square of the lobe's
/// width, as alpha2_under_sun gives it. Views from behind count as grazing ones, n·v = 1e-4. The
/// peak is of order 1 / alpha2: more than half floats hold below alpha2 = 5e-6.
Vec3d direct_specular(const Vec3d& normal, const Vec3d& view, const Vec3d& towards_light,
                      const Vec3d& f0, double alpha2);

/// The square of the lobe's width under a light whose disc has this radius, in radians (the sun:
/// sun_radius; 0 for a light without extent): alpha² + (radius / 2)², in [1e-8, 1].
///
/// The half vectors towards a small disc fill a disc of half its radius R, and the mean of
/// D = alpha² / (pi (alpha² + s²)²) over one around the normal is 1 / (pi (alpha² + R²)), which is the
/// peak of a lobe of alpha² + R². So the highlight's brightness is that of the disc, its energy is kept
/// as that of every GGX lobe, and a mirror shows a blurred disc of the disc's mean radiance instead of
/// an infinite point. Off the centre the shape is an approximation, wrong by up to 0.03 % of the peak
/// at perceptual roughness 0.2, 1 % at 0.1, 11 % at 0.05; below, the disc's sharp edge is lost
/// (measured, tests/unit/shading).
double alpha2_under_sun(double perceptual_roughness, double angular_radius);

/// Mean angular radius of the sun from Earth, in radians: 0.2666 degrees.
inline constexpr double sun_radius = 0.004653;

}  // namespace splitsum
