#pragma once

#include <cstdint>
#include <span>

#include "splitsum/math/vec.h"

namespace splitsum {

/// How far values are from the truth, under the names used everywhere in this project.
struct ErrorFigures {
    double rel_rms = 0;  ///< sqrt(sum (x - ref)² / sum ref²) over texels and channels
    double max_rel = 0;  ///< the largest |x - ref| / ref of a channel, where ref is above 0
    double max_abs = 0;  ///< the largest |x - ref| of a channel
    double bias = 0;     ///< sum x / sum ref - 1
    int64_t texels = 0;  ///< how many were compared
};

/// Compares two equally long lists. Where every reference is 0, rel_rms and bias are 0 if the
/// values are 0 too and infinite otherwise. NaN in either list makes every figure NaN or infinite,
/// never a good one.
ErrorFigures error_figures(std::span<const Vec3> values, std::span<const Vec3> reference);
/// The same for texels of `channels` numbers each.
ErrorFigures error_figures(std::span<const float> values, std::span<const float> reference,
                           int channels);

}  // namespace splitsum
