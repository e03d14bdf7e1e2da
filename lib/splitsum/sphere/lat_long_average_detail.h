#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "splitsum/math/vec.h"

namespace splitsum {

/// cos(pi v0) - cos(pi v1), the share of the sphere (times 2) between two polar angles, without
/// cancellation at the poles.
inline double zone_height(double v0, double v1) {
    return 2 * std::sin(0.5 * std::numbers::pi * (v0 + v1)) *
           std::sin(0.5 * std::numbers::pi * (v1 - v0));
}

/// The mean radiance of a row of `width` texels over the part from `from` to `to`, in texels. A
/// texel is `floats_per_texel` floats of which the first three are its radiance.
inline Vec3d mean_over_arc(const float* row, int width, int floats_per_texel, double from,
                           double to) {
    Vec3d sum(0);
    for (int x = int(from); x < width && x < to; ++x) {
        const double share = std::min(to, x + 1.0) - std::max(from, double(x));
        const float* texel = row + std::size_t(x) * std::size_t(floats_per_texel);
        sum += share * Vec3d(texel[0], texel[1], texel[2]);
    }
    return sum / (to - from);
}

}  // namespace splitsum
