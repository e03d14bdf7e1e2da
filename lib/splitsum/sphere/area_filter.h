#pragma once

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/math/vec.h"
#include "splitsum/sphere/cubemap.h"
#include "splitsum/sphere/environment.h"

namespace splitsum {

/// The mirror image: each cube texel is the mean of the environment over the texel's solid angle.
///
/// By Green's theorem the integral over a texel is a contour integral along its edges,
///     ∫∫ L d(cos theta) dphi = ∮ F dphi,   F(phi, theta) = ∫_0^theta L sin dtheta',
/// and F is a lookup in column sums. Every edge is shared by two texels, so nothing is counted
/// twice or lost, whatever the sizes: a sun of one texel keeps its energy. Along an edge F is
/// integrated over each panorama column it crosses by the midpoint or by two Gauss points; the
/// relative error for a smooth sky is below 1e-5, and a texel's share of a lit panorama texel is
/// right to about 1 % of that texel.
///
/// `panorama_from_cube` must turn about y only (sphere/orientation.h makes such matrices). Cost:
/// one pass over the environment, three doubles of memory a texel of it, and about four lookups for
/// each edge and column. Reports one step of progress a row of texels (the caller begins the stage);
/// fails only when cancelled.
Result<Cubemap> area_filtered_cubemap(const Environment& environment, int face_size,
                                      const Mat3d& panorama_from_cube, Progress& progress);

}  // namespace splitsum
