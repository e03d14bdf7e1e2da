#pragma once

#include <span>

#include "splitsum/ltc/transformed_cosine.h"

namespace splitsum {

/// What a transformed cosine gathers from a convex polygonal light of radiance 1, in [0, 1]: the
/// polygon goes to cosine space, is clipped to the horizon there and has Lambert's closed form.
/// Times the table's magnitude it is the reflected radiance of a surface with reflectance 1.
///
/// `polygon` holds corners in order, as points seen from the shaded one, in the frame of
/// transformed_cosine.h (+z the normal, +x the viewer's side); winding and distance do not matter,
/// and the shaded point is not on it. As in the engines the horizon of the surface itself does not
/// clip: the little of a fitted lobe that lies below it gathers light there. Lights that cross it
/// far below are better clipped by clip_to_horizon (brdf/polygon.h) first.
double ltc_polygon_light(const LtcInverse& inverse, std::span<const Vec3d> polygon);

}  // namespace splitsum
