#include "splitsum/filter/irradiance_harmonics.h"

#include <algorithm>
#include <cmath>

#include "splitsum/brdf/band_factors.h"
#include "splitsum/filter/harmonics_of_environment.h"
#include "splitsum/math/harmonics.h"

namespace splitsum {
namespace {

constexpr int directions_per_turn = 96;  // of the grid on which negative values are looked for

// Bands scaled by 1 / (1 + lambda l² (l + 1)²).
std::vector<Vec3d> damped(const std::vector<Vec3d>& coefficients, int order, double lambda) {
    std::vector<Vec3d> result = coefficients;
    for (int l = 0; l <= order; ++l)
        for (int m = -l; m <= l; ++m)
            result[harmonic_index(l, m)] /= 1 + lambda * std::pow(double(l) * (l + 1), 2);
    return result;
}

// The smallest value of any channel over a grid of directions, divided by the channel's mean.
double lowest_share(const std::vector<Vec3d>& coefficients, int order) {
    std::vector<double> values(coefficients.size());
    double lowest = 1;
    for (int y = 0; y <= directions_per_turn / 2; ++y)
        for (int x = 0; x < directions_per_turn; ++x) {
            const Vec3d d = direction_of_lat_long(double(x) / directions_per_turn,
                                                  2.0 * y / directions_per_turn);
            evaluate_harmonics(d, order, values);
            Vec3d sum(0);
            for (size_t i = 0; i < values.size(); ++i) sum += values[i] * coefficients[i];
            for (int c = 0; c < 3; ++c) {
                const double mean = coefficients[0][c] * values[0];
                if (mean > 0) lowest = std::min(lowest, sum[c] / mean);
            }
        }
    return lowest;
}

// The smallest damping that leaves nothing negative, by bisection: more damping only raises the
// minimum, and an infinite one leaves the mean.
double smallest_lambda(const std::vector<Vec3d>& coefficients, int order) {
    if (lowest_share(coefficients, order) >= 0) return 0;
    double low = 0, high = 1e-3;
    while (lowest_share(damped(coefficients, order, high), order) < 0) high *= 2;
    for (int step = 0; step < 20; ++step) {
        const double middle = 0.5 * (low + high);
        (lowest_share(damped(coefficients, order, middle), order) < 0 ? low : high) = middle;
    }
    return high;
}

}  // namespace

IrradianceHarmonics irradiance_harmonics(const Environment& environment, int order, bool windowed,
                                         const Mat3d& panorama_from_cube) {
    IrradianceHarmonics result;
    result.order = order;
    result.coefficients = harmonics_of_environment(environment, order, panorama_from_cube);
    const std::vector<double> factors = band_factors({LobeKind::cosine}, order + 1);
    for (int l = 0; l <= order; ++l)
        for (int m = -l; m <= l; ++m)
            result.coefficients[harmonic_index(l, m)] *= factors[size_t(l)];
    if (windowed) {
        result.window_lambda = smallest_lambda(result.coefficients, order);
        result.coefficients = damped(result.coefficients, order, result.window_lambda);
    }
    result.lowest = lowest_share(result.coefficients, order);
    return result;
}

Vec3d evaluate(const IrradianceHarmonics& harmonics, const Vec3d& normal) {
    std::vector<double> values(harmonics.coefficients.size());
    evaluate_harmonics(normal, harmonics.order, values);
    Vec3d sum(0);
    for (size_t i = 0; i < values.size(); ++i) sum += values[i] * harmonics.coefficients[i];
    return sum;
}

}  // namespace splitsum
