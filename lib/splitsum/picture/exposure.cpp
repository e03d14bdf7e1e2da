#include "splitsum/picture/exposure.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/base/parallel.h"
#include "splitsum/image/luminance.h"
#include "splitsum/math/vec.h"

namespace splitsum {
namespace {

// The display transform shows mid grey, 0.18, at a tenth of white: darker than people like pictures.
constexpr double shown_mean = 0.25;

/// exp of the mean of log luminance over the sphere; darkness counts as `darkest`.
double logarithmic_mean(const Cubemap& cubemap, double darkest) {
    const int size = cubemap.face_size;
    const double sum = ordered_sum(size, [&](int y) {
        double row = 0;
        for (int x = 0; x < size; ++x) {
            const double weight = solid_angle_of_texel(x, y, size);
            for (int face = 0; face < face_count; ++face)
                row += weight * std::log(std::max(luminance(cubemap.at(face, x, y)), darkest));
        }
        return row;
    });
    return std::exp(sum / (4 * std::numbers::pi));
}

}  // namespace

double exposure_stops_of(const Cubemap& radiance) {
    const double mean = luminance(mean_radiance(radiance));
    if (!(mean > 0)) return 0;
    return std::log2(shown_mean / std::sqrt(mean * logarithmic_mean(radiance, 1e-4 * mean)));
}

}  // namespace splitsum
