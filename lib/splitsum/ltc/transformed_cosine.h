#pragma once

#include <numbers>

#include "splitsum/math/vec.h"

namespace splitsum {

// Linearly transformed cosines: Heitz, Dupuy, Hill & Neubelt 2016, "Real-Time Polygonal-Light
// Shading with Linearly Transformed Cosines", ACM TOG 35(4). A matrix M carries the clamped cosine
// max(z, 0) / pi to a lobe that resembles a BRDF; polygons carried back by the inverse of M keep
// straight edges, so that the lobe's integral over them has a closed form.
//
// Here as in the engines: +z is the surface's normal and +x the side on which the viewer is,
// v = (sqrt(1 - n·v²), 0, n·v), so a reflection lobe leans to -x.

/// The inverse of M for a lobe that is symmetric about the plane of v and n, without a unit: scaled
/// so that its middle entry, the one that acts on y, is 1:
///
///     | m00  0  m02 |
///     |  0   1   0  |
///     | m20  0  m22 |
///
/// The default is the clamped cosine itself.
struct LtcInverse {
    double m00 = 1;
    double m20 = 0;
    double m02 = 0;
    double m22 = 1;
};

/// Positive for every fitted lobe.
inline double determinant(const LtcInverse& inverse) {
    return inverse.m00 * inverse.m22 - inverse.m02 * inverse.m20;
}

/// The direction, not normalised, in the space where the lobe is a clamped cosine about +z.
inline Vec3d to_cosine_space(const LtcInverse& inverse, const Vec3d& direction) {
    return {inverse.m00 * direction.x + inverse.m02 * direction.z, direction.y,
            inverse.m20 * direction.x + inverse.m22 * direction.z};
}

/// The way back: the direction, not normalised, of one in cosine space. Positive determinant.
inline Vec3d from_cosine_space(const LtcInverse& inverse, const Vec3d& direction) {
    const double factor = 1 / determinant(inverse);
    return {factor * (inverse.m22 * direction.x - inverse.m02 * direction.z), direction.y,
            factor * (inverse.m00 * direction.z - inverse.m20 * direction.x)};
}

/// The lobe per steradian at a unit direction (eq. 1): it integrates to 1 over all directions, some
/// of which may lie below the surface.
inline double ltc_density(const LtcInverse& inverse, const Vec3d& direction) {
    const Vec3d w = to_cosine_space(inverse, direction);
    if (w.z <= 0) return 0;
    const double length2 = dot(w, w);
    return w.z * determinant(inverse) * std::numbers::inv_pi / (length2 * length2);
}

}  // namespace splitsum
