#include "splitsum/measure/error_figures.h"

#include <cmath>
#include <limits>

namespace splitsum {
namespace {

// 0 / 0 is no error; anything else over 0 is an infinite one.
double ratio(double error, double reference) {
    if (reference > 0 || std::isnan(error) || std::isnan(reference)) return error / reference;
    return error == 0 ? 0 : std::copysign(std::numeric_limits<double>::infinity(), error);
}

// The larger of the two, NaN if either is.
double worse(double a, double b) { return b > a || std::isnan(b) ? b : a; }

std::span<const float> floats_of(std::span<const Vec3> texels) {
    static_assert(sizeof(Vec3) == 3 * sizeof(float));
    return {texels.empty() ? nullptr : &texels.front().x, 3 * texels.size()};
}

}  // namespace

ErrorFigures error_figures(std::span<const Vec3> values, std::span<const Vec3> reference) {
    return error_figures(floats_of(values), floats_of(reference), 3);
}

ErrorFigures error_figures(std::span<const float> values, std::span<const float> reference,
                           int channels) {
    ErrorFigures result;
    double error2 = 0, reference2 = 0, sum = 0, reference_sum = 0;
    for (size_t i = 0; i < values.size(); ++i) {
        const double x = double(values[i]), truth = double(reference[i]);
        const double error = x - truth;
        error2 += error * error;
        reference2 += truth * truth;
        sum += x;
        reference_sum += truth;
        result.max_abs = worse(result.max_abs, std::abs(error));
        if (truth != 0) result.max_rel = worse(result.max_rel, std::abs(error / truth));
    }
    result.rel_rms = std::sqrt(ratio(error2, reference2));
    result.bias = ratio(sum - reference_sum, reference_sum);
    result.texels = std::ssize(values) / channels;
    return result;
}

}  // namespace splitsum
