#pragma once

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/sphere/cubemap.h"
#include "splitsum/sphere/environment.h"

namespace splitsum {

/// The judge of mirror images: the mean of the environment over each texel of a cube whose axes are
/// those of the panorama. It shares nothing with area_filtered_cubemap. Lines across a texel are cut
/// where they meet the panorama's columns (planes) and rows (cones), and each piece's solid angle is
/// known in closed form; the lines, 16384 a face, are added by the midpoint rule.
///
/// Error below 1e-4 of the panorama texels met, where a curved row touches a line. Cost: about 100000
/// lines across texels for each texel along an edge, each of which tries every column and row: a
/// third of a core second for 64 rows and faces of 8. Fails only when cancelled.
Result<Cubemap> exact_mirror(const Environment& environment, int face_size, Progress& progress);

}  // namespace splitsum
