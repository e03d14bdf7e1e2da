#pragma once

#include <span>

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/filter/methods.h"
#include "splitsum/sphere/cubemap.h"

namespace splitsum {

struct FilteredCubemap {
    Cubemap cubemap;
    LevelAccount account;
};

/// Sets channels below 0 to 0, and counts them: radiance is never negative, but a truncated series
/// or rounding can be.
int64_t clamp_negative(std::span<Vec3> texels);

/// One lobe of a prepared filter at every texel centre of a cube, in parallel over texel rows.
/// `panorama_from_cube` takes cube directions to those of the environment; the keys of the texels
/// count from `first_key`. Negative values are clamped and counted. The bits do not depend on the number of threads. Reports one step of
/// progress a row (the caller begins the stage); fails only when cancelled.
Result<FilteredCubemap> filter_cubemap(const PreparedFilter& filter, size_t lobe_index,
                                       int face_size, const Mat3d& panorama_from_cube,
                                       uint32_t first_key, Progress& progress);

}  // namespace splitsum
