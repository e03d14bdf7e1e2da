#include "splitsum/brdf/disney_diffuse.h"

#include <numbers>

#include "splitsum/math/quadrature.h"

namespace splitsum {
namespace {

// F90 - 1 = constant + slope l·v, and what the whole lobe is multiplied with.
struct Terms {
    double constant;
    double slope;
    double factor;
};

Terms terms_of(DisneyDiffuse lobe, double perceptual_roughness) {
    const double r = perceptual_roughness;
    if (lobe == DisneyDiffuse::burley) return {r - 0.5, r, 1};
    return {1.5 * r - 1, r, 1 + r * (1 / 1.51 - 1)};
}

double fifth_power(double x) { return x * x * x * x * x; }

}  // namespace

double disney_diffuse(DisneyDiffuse lobe, double n_dot_l, double n_dot_v, double l_dot_v,
                      double perceptual_roughness) {
    const Terms terms = terms_of(lobe, perceptual_roughness);
    const double rise = terms.constant + terms.slope * l_dot_v;
    return terms.factor * std::numbers::inv_pi * (1 + rise * fifth_power(1 - n_dot_l)) *
           (1 + rise * fifth_power(1 - n_dot_v));
}

// With g = F90 - 1, a = (1 - n·l)^5 and b = (1 - n·v)^5 the lobe is 1 + g (a + b) + g² a b, and
// l·v = n·l n·v + sin l sin v cos phi: the mean of g over the azimuth is its value at cos phi = 0,
// that of g² exceeds the square of it by (slope sin l sin v)² / 2.
double disney_diffuse_albedo(DisneyDiffuse lobe, double n_dot_v, double perceptual_roughness) {
    static const QuadratureRule rule = gauss_legendre(9);
    const Terms terms = terms_of(lobe, perceptual_roughness);
    const double b = fifth_power(1 - n_dot_v);
    const double sin2_v = (1 - n_dot_v) * (1 + n_dot_v);
    return terms.factor * integrate(rule, 0, 1, [&](double n_dot_l) {
               const double a = fifth_power(1 - n_dot_l);
               const double sin2_l = (1 - n_dot_l) * (1 + n_dot_l);
               const double g = terms.constant + terms.slope * n_dot_l * n_dot_v;
               const double g2 = g * g + 0.5 * terms.slope * terms.slope * sin2_l * sin2_v;
               return 2 * n_dot_l * (1 + g * (a + b) + g2 * a * b);
           });
}

}  // namespace splitsum
