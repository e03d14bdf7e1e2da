#include "splitsum/table/average_albedo_exact.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/math/quadrature.h"
#include "splitsum/table/graded_detail.h"

namespace splitsum {
namespace {

// pi E_avg = ∫∫ D V (n·l) (n·v) dl dv. About a half vector h at the angle theta_h from the normal,
// light and view lie opposite at the angle theta_d, so dl dv = 4 cos theta_d dh dd and
//
//     n·l, n·v = cos theta_h cos theta_d -+ sin theta_h sin theta_d cos phi.
//
// Both are above the horizon for tan theta_d < 1 / (tan theta_h |cos phi|); the quarters of the
// circle are equal. Facets follow tan² theta_h = alpha² (1 - s²) / s² with s in [0, 1], where
//
//     D dh = 2 s ds / cos theta_h = 2 sqrt(s² + alpha² (1 - s²)) ds.
constexpr double growth = 1.5;
constexpr int nodes_per_panel = 8;
constexpr double finest = 1e-3;  // shorter lengths hold less than 1e-6 of the energy

struct Facet {
    double cosine;
    double sine;
};

// 4 cos theta_d V (n·l) (n·v) sin theta_d over theta_d.
double integrate_difference(const QuadratureRule& rule, SmithTerm term, double alpha,
                            const Facet& facet, double cos_phi) {
    const double across = facet.sine * cos_phi;
    const double horizon = std::atan2(facet.cosine, across);
    // At the horizon of the light n·l competes with alpha and with n·v.
    const double n_dot_v = 2 * across * std::sin(horizon);
    const double first = std::max(finest, 0.2 * std::min(alpha, n_dot_v));
    return integrate_graded(rule, horizon, 0, first, growth, [&](double theta) {
        const double c = std::cos(theta), s = std::sin(theta);
        const double n_dot_l = facet.cosine * c - across * s;
        const double n_dot_v_here = facet.cosine * c + across * s;
        if (n_dot_l <= 0) return 0.0;
        return 4 * c * s * smith_visibility(term, n_dot_l, n_dot_v_here, alpha) * n_dot_l *
               n_dot_v_here;
    });
}

// Over the circle about h; for steep facets the horizon moves within 1 / tan theta_h of phi = pi / 2.
double integrate_circle(const QuadratureRule& rule, SmithTerm term, double alpha,
                        const Facet& facet) {
    const double first = std::max(finest, 0.5 * std::min(1.0, facet.cosine / facet.sine));
    return 4 * integrate_graded(rule, 0.5 * std::numbers::pi, 0, first, growth, [&](double phi) {
               return integrate_difference(rule, term, alpha, facet, std::cos(phi));
           });
}

}  // namespace

double average_albedo_exact(SmithTerm term, double alpha) {
    if (alpha <= 0) return 1;
    const QuadratureRule rule = gauss_legendre(nodes_per_panel);
    const double sum =
        integrate_graded(rule, 0, 1, std::max(finest, 0.2 * alpha), growth, [&](double s) {
            const double across = alpha * std::sqrt((1 - s) * (1 + s));
            const double norm = std::hypot(s, across);
            return 2 * norm * integrate_circle(rule, term, alpha, {s / norm, across / norm});
        });
    return sum * std::numbers::inv_pi;
}

}  // namespace splitsum
