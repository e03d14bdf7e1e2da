#pragma once

#include <memory>

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/math/vec.h"
#include "splitsum/sphere/area_geometry.h"
#include "splitsum/sphere/cubemap.h"
#include "splitsum/sphere/environment.h"

namespace splitsum {

/// The mirror image: each cube texel is the mean of the environment over the texel's solid angle.
///
/// By Green's theorem the integral over a texel is a contour integral along its edges,
///     ∫∫ L d(cos theta) dphi = ∮ F dphi,   F(phi, theta) = ∫_0^theta L sin dtheta',
/// and F lies between two sums of a column's texels. Every edge is shared by two texels, so nothing
/// is counted twice or lost, whatever the sizes: a sun of one texel keeps its energy (to 1e-7).
/// Each edge is cut where it meets another column or row of the panorama; in between F is linear in
/// cos theta, so that each texel gets its share of every panorama texel (tested to 1 % of it, which
/// is as far as sums over points can tell). Around a texel the azimuths cancel exactly: below a sun
/// of 1e6 there is no trace of it.
///
/// `panorama_from_cube` must turn about y, perhaps after mirroring (sphere/orientation.h makes such
/// matrices). Cost: one pass over the environment, and one visit for each edge and panorama texel
/// that meet; AreaFilterBuilder does the same for rows that are not kept, and AreaGeometry what
/// panoramas of one size have in common. Reports one step of progress a row of texels (the caller
/// begins the stage); fails only when cancelled.
Result<Cubemap> area_filtered_cubemap(const Environment& environment, int face_size,
                                      const Mat3d& panorama_from_cube, Progress& progress);

/// The same by a geometry that is at hand, whose height is that of the environment.
Result<Cubemap> area_filtered_cubemap(const Environment& environment,
                                      std::shared_ptr<const AreaGeometry> geometry,
                                      Progress& progress);

}  // namespace splitsum
