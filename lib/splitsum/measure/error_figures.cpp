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

template <class Vector>
ErrorFigures figures(std::span<const Vector> values, std::span<const Vector> reference) {
    ErrorFigures result;
    double error2 = 0, reference2 = 0, sum = 0, reference_sum = 0;
    for (size_t i = 0; i < values.size(); ++i)
        for (int c = 0; c < Vector::length(); ++c) {
            const double x = double(values[i][c]), truth = double(reference[i][c]);
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
    result.texels = std::ssize(values);
    return result;
}

}  // namespace

ErrorFigures error_figures(std::span<const Vec3> values, std::span<const Vec3> reference) {
    return figures(values, reference);
}

ErrorFigures error_figures(std::span<const Vec2> values, std::span<const Vec2> reference) {
    return figures(values, reference);
}

}  // namespace splitsum
