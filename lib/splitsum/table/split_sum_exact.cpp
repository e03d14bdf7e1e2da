#include "splitsum/table/split_sum_exact.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/brdf/ggx.h"
#include "splitsum/math/quadrature.h"
#include "splitsum/table/graded_detail.h"

namespace splitsum {
namespace {

// In spherical coordinates of the half vector, with the view in the plane phi = 0,
//
//     n·l = 2 (v·h) (n·h) - n·v = s sin 2 theta cos phi + n·v cos 2 theta,   s = sin theta_v,
//
// is a single cosine of 2 theta, so for every phi the light is above the horizon exactly for
//
//     theta < pi / 4 + atan2(s cos phi, n·v) / 2.
//
// Inside of that the integrand 4 D V (n·l) (v·h) is analytic and even in phi. (dl = 4 v·h dh.)
struct Setting {
    SmithTerm term;
    double n_dot_v;
    double sin_v;
    double alpha;
    const QuadratureRule& rule;
};

SplitSum operator+(const SplitSum& x, const SplitSum& y) { return {x.a + y.a, x.b + y.b}; }

// The integrand for dtheta dphi.
SplitSum integrand(const Setting& at, double cos_phi, double theta) {
    const double sin_theta = std::sin(theta);
    const double cos_theta = std::cos(theta);
    const double v_dot_h = at.sin_v * sin_theta * cos_phi + at.n_dot_v * cos_theta;
    const double n_dot_l = 2 * at.sin_v * sin_theta * cos_theta * cos_phi +
                           at.n_dot_v * (cos_theta * cos_theta - sin_theta * sin_theta);
    if (n_dot_l <= 0 || v_dot_h <= 0) return {0, 0};
    const double reflected = 4 * ggx_density(sin_theta * sin_theta, at.alpha) *
                             smith_visibility(at.term, n_dot_l, at.n_dot_v, at.alpha) * n_dot_l *
                             v_dot_h * sin_theta;
    const double fresnel = std::pow(std::max(0.0, 1 - v_dot_h), 5);
    return {(1 - fresnel) * reflected, fresnel * reflected};
}

// Panels that start at half of `first` at `from`.
template <class Function>
SplitSum graded(const QuadratureRule& rule, double from, double to, double first,
                const Function& f) {
    SplitSum sum{0, 0};
    visit_graded(rule, from, to, first, 0.5, [&](double at, double weight) {
        const SplitSum value = f(at);
        sum = sum + SplitSum{weight * value.a, weight * value.b};
    });
    return sum;
}

// Over theta, graded from the peak of the distribution and from the horizon.
SplitSum integrate_theta(const Setting& at, double phi) {
    const double cos_phi = std::cos(phi);
    const double horizon =
        0.25 * std::numbers::pi + 0.5 * std::atan2(at.sin_v * cos_phi, at.n_dot_v);
    const auto f = [&](double theta) { return integrand(at, cos_phi, theta); };
    const double middle = 0.5 * horizon;
    // At the horizon n·l competes with alpha, and with n·v in the height-correlated term.
    const double first = at.n_dot_v > 0 ? std::min(at.alpha, at.n_dot_v) : at.alpha;
    return graded(at.rule, 0, middle, first, f) + graded(at.rule, horizon, middle, first, f);
}

}  // namespace

SplitSum split_sum_exact(SmithTerm term, double n_dot_v, double alpha, int nodes_per_panel) {
    if (alpha <= 0) {
        const double fresnel = std::pow(1 - n_dot_v, 5);
        return {1 - fresnel, fresnel};
    }
    const QuadratureRule rule = gauss_legendre(nodes_per_panel);
    const double sin_v = std::sqrt((1 - n_dot_v) * (1 + n_dot_v));
    const Setting at{term, n_dot_v, sin_v, alpha, rule};
    const auto f = [&](double phi) { return integrate_theta(at, phi); };
    // At grazing views the horizon moves from one side of the lobe to the other within an angle of
    // n·v about phi = pi / 2; seen edge on, the far half of the circle is below it and n·l
    // competes with alpha there.
    constexpr double quarter = 0.5 * std::numbers::pi;
    const double first = n_dot_v > 0 ? n_dot_v : alpha;
    const SplitSum half =
        graded(rule, quarter, 0, first, f) + graded(rule, quarter, 2 * quarter, first, f);
    return {2 * half.a, 2 * half.b};
}

}  // namespace splitsum
