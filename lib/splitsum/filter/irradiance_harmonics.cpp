#include "splitsum/filter/irradiance_harmonics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/brdf/band_factors.h"
#include "splitsum/filter/harmonics_of_environment.h"
#include "splitsum/math/harmonics.h"

namespace splitsum {
namespace {

constexpr int directions_per_turn = 48;  // at least, of the grid on which lows are looked for

// Bands scaled by 1 / (1 + lambda l² (l + 1)²).
std::vector<Vec3d> damped(const std::vector<Vec3d>& coefficients, int order, double lambda) {
    std::vector<Vec3d> result = coefficients;
    for (int l = 0; l <= order; ++l)
        for (int m = -l; m <= l; ++m)
            result[harmonic_index(l, m)] /= 1 + lambda * std::pow(double(l) * (l + 1), 2);
    return result;
}

// One channel of a series as a function on the sphere.
class ChannelSeries {
public:
    ChannelSeries(const std::vector<Vec3d>& coefficients, int order, int channel)
        : coefficients_(coefficients),
          order_(order),
          channel_(channel),
          values_(coefficients.size()) {}

    double at(const LatLong& place) {
        evaluate_harmonics(direction_of_lat_long(place.u, place.v), order_, values_);
        double sum = 0;
        for (size_t i = 0; i < values_.size(); ++i) sum += values_[i] * coefficients_[i][channel_];
        return sum;
    }

private:
    const std::vector<Vec3d>& coefficients_;
    int order_;
    int channel_;
    std::vector<double> values_;
};

// The smallest value, from the lowest point of a grid downhill in ever smaller steps, to
// about 1e-9 of the mean: the grid alone misses it by 1e-4.
double lowest_value(ChannelSeries series, int order) {
    const int grid = std::max(directions_per_turn, 8 * order);
    LatLong lowest_at{0, 0};
    double lowest = series.at(lowest_at);
    const auto try_at = [&](double u, double v) {
        const double value = series.at({u, v});
        if (value >= lowest) return false;
        lowest = value;
        lowest_at = {u, v};
        return true;
    };
    for (int y = 0; y <= grid / 2; ++y)
        for (int x = 0; x < grid; ++x) try_at(double(x) / grid, 2.0 * y / grid);
    for (double step = 1.0 / grid; step > 1e-5;) {
        const auto [u, v] = lowest_at;
        const bool lower = try_at(u - step, v) || try_at(u + step, v) || try_at(u, v - step) ||
                           try_at(u, v + step);
        if (!lower) step *= 0.5;
    }
    return lowest;
}

// The smallest value of any channel over the sphere, divided by the channel's mean.
double lowest_share(const std::vector<Vec3d>& coefficients, int order) {
    double lowest = 1;
    for (int channel = 0; channel < 3; ++channel) {
        const double mean = coefficients[0][channel] / std::sqrt(4 * std::numbers::pi);
        if (mean <= 0) continue;
        lowest = std::min(lowest, lowest_value({coefficients, order, channel}, order) / mean);
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

IrradianceHarmonics irradiance_harmonics(const FilterSource& source, int order, bool windowed,
                                         const Mat3d& panorama_from_cube) {
    IrradianceHarmonics result;
    result.order = order;
    result.coefficients = harmonics_of(source, order, panorama_from_cube);
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
