#pragma once

#include <span>

#include "splitsum/ltc/transformed_cosine.h"
#include "splitsum/math/vec.h"

namespace splitsum {

// How a table of transformed cosines is used (ltc_tables.h): the twin of
// shaders/include/splitsum_area_light.glsl. `read` holds both layers, as read_bilinear gives them; where
// they are read is texture_coordinates (bilinear.h) of the kind's default_plan.

/// The matrix.
inline LtcInverse ltc_inverse(std::span<const double> read) {
    return {.m00 = read[0], .m20 = read[1], .m02 = read[2], .m22 = read[3]};
}

/// What the form factor of a polygon in cosine space is multiplied with (Hill 2016, "LTC Fresnel
/// Approximation"). `f0` is the reflectance at normal incidence, in [0, 1].
inline double ltc_reflectance(std::span<const double> read, double f0) {
    return f0 * read[4] + (1 - f0) * read[5];
}

/// Where the last channel is sampled, in a table of `size` texels with the default layout and axes:
/// the share of a sphere that the horizon leaves (clipped_sphere.h), `cos_to_centre` in [-1, 1] and
/// `form_factor` in [0, 1], which are clamped.
Vec2d ltc_sphere_coordinates(double cos_to_centre, double form_factor, int size);

}  // namespace splitsum
