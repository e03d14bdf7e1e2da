#include "splitsum/filter/gaussians.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "splitsum/brdf/band_factors.h"
#include "splitsum/filter/gaussians_least_squares.h"
#include "splitsum/filter/harmonics_of_environment.h"
#include "splitsum/math/harmonics.h"
#include "splitsum/math/quadrature.h"

namespace splitsum {
namespace {

constexpr double pi = std::numbers::pi;

// The cosine leaves 2e-3 of band 16.
constexpr int highest_band = 16;

// The sharpness for each lobe of a set. On the four kinds of sky of the tests anything from 0.5 to
// 0.8 is as good; wider lobes cannot follow a studio, narrower ones ripple under clouds.
constexpr double sharpness_share = 0.6;

std::vector<Vec3d> fibonacci_axes(int count) {
    std::vector<Vec3d> axes;
    for (int i = 0; i < count; ++i) {
        const double height = 1 - (2 * i + 1.0) / count;
        const double sine = std::sqrt((1 - height) * (1 + height));
        const double azimuth = 2 * pi * i / std::numbers::phi;
        axes.emplace_back(sine * std::cos(azimuth), height, sine * std::sin(azimuth));
    }
    return axes;
}

// P_0 .. P_highest_band at x.
std::vector<double> legendre_values(double x) {
    std::vector<double> values = {1, x};
    for (int l = 1; l < highest_band; ++l)
        values.push_back(((2 * l + 1) * x * values[size_t(l)] - l * values[size_t(l) - 1]) /
                         (l + 1));
    return values;
}

// The factors by which reading a lobe off a point of light scales the bands (Funk-Hecke).
std::vector<double> factors_of_lobe(double sharpness) {
    std::vector<double> factors(highest_band + 1, 0.0);
    const QuadratureRule rule = gauss_legendre(128);
    for (size_t i = 0; i < rule.nodes.size(); ++i) {
        const double x = rule.nodes[i];
        const double weight = 2 * pi * rule.weights[i] * gaussian_irradiance_over_pi(sharpness, x);
        const std::vector<double> legendre = legendre_values(x);
        for (size_t l = 0; l < factors.size(); ++l) factors[l] += weight * legendre[l];
    }
    return factors;
}

// Inner products over the sphere of what the lobes are read as: by the addition theorem
// sum over l of h_l² (2 l + 1) / (4 pi) P_l(cosine between the axes).
std::vector<double> products_of_lobes(const std::vector<Vec3d>& axes,
                                      const std::vector<double>& factors) {
    std::vector<double> products;
    for (const Vec3d& a : axes)
        for (const Vec3d& b : axes) {
            const std::vector<double> legendre = legendre_values(dot(a, b));
            double sum = 0;
            for (size_t l = 0; l < factors.size(); ++l)
                sum += factors[l] * factors[l] * (2 * double(l) + 1) / (4 * pi) * legendre[l];
            products.push_back(sum);
        }
    return products;
}

// Inner products of the light's E / pi with the lobe about `axis`.
Vec3d product_with_light(const std::vector<Vec3d>& radiance, const Vec3d& axis,
                         const std::vector<double>& factors) {
    static constexpr Lobe cosine{LobeKind::cosine};
    const std::vector<double> of_cosine = band_factors(cosine, highest_band + 1);
    std::vector<double> harmonics(radiance.size());
    evaluate_harmonics(axis, highest_band, harmonics);
    Vec3d sum(0);
    for (int l = 0; l <= highest_band; ++l)
        for (int m = -l; m <= l; ++m) {
            const size_t i = harmonic_index(l, m);
            sum += factors[size_t(l)] * of_cosine[size_t(l)] * harmonics[i] * radiance[i];
        }
    return sum;
}

}  // namespace

SphericalGaussians fit_gaussians(const FilterSource& source, int count,
                                 const Mat3d& panorama_from_cube) {
    assert(count >= fewest_gaussians && count <= most_gaussians);
    SphericalGaussians gaussians{sharpness_share * count, fibonacci_axes(count), {}};
    gaussians.amplitudes.assign(gaussians.axes.size(), Vec3d(0));
    const std::vector<double> factors = factors_of_lobe(gaussians.sharpness);
    const std::vector<double> matrix = products_of_lobes(gaussians.axes, factors);
    const std::vector<Vec3d> radiance = harmonics_of(source, highest_band, panorama_from_cube);
    std::vector<Vec3d> products;
    for (const Vec3d& axis : gaussians.axes)
        products.push_back(product_with_light(radiance, axis, factors));
    for (int channel = 0; channel < 3; ++channel) {
        std::vector<double> rhs;
        for (const Vec3d& product : products) rhs.push_back(product[channel]);
        const std::vector<double> solved = non_negative_least_squares(matrix, rhs);
        for (size_t i = 0; i < solved.size(); ++i) gaussians.amplitudes[i][channel] = solved[i];
    }
    return gaussians;
}

Vec3d irradiance_over_pi(const SphericalGaussians& gaussians, const Vec3d& normal) {
    Vec3d sum(0);
    for (size_t i = 0; i < gaussians.axes.size(); ++i)
        sum += gaussian_irradiance_over_pi(gaussians.sharpness, dot(gaussians.axes[i], normal)) *
               gaussians.amplitudes[i];
    return sum;
}

// Along the axis the integral is elementary: with s the sharpness and e = exp(-s),
//     E(+1) = 2 pi / s (1 - 1/s + e/s),    E(-1) = 2 pi / s ((e - e²)/s - e²).
// Hill's ramp y(c) is max(c, 0), and within |c| <= x / (4 k²) the parabola (k c + x / (4 k))² / x
// that touches it at both ends; x = sqrt(1 - rise) grows as the lobe widens. His k = 0.36 leaves
// 1.9 %, the k below, refitted with the exact ends, 1.1 %. Where
// the parabola reaches past c = -1, its value there is taken off, so that y runs from 0 to 1.
double gaussian_irradiance_over_pi(double sharpness, double cosine) {
    const double inverse = 1 / sharpness;
    const double e = std::exp(-sharpness), e2 = e * e;
    const double lowest = (e - e2) * inverse - e2;
    const double rise = 1 - inverse + e * inverse - lowest;
    const double k = 0.39 - 0.1 * inverse;
    const double x = std::sqrt(1 - rise);
    const double shift = x / (4 * k);
    const auto parabola = [=](double c) { return (k * c + shift) * (k * c + shift) / x; };
    const double excess = shift > k ? parabola(-1) : 0;
    const double ramp =
        std::abs(k * cosine) <= shift ? parabola(cosine) - excess : std::max(cosine, 0.0);
    return 2 * inverse * (rise * ramp + lowest);
}

}  // namespace splitsum
