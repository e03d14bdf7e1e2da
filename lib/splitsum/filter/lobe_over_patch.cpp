#include "splitsum/filter/lobe_over_patch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/math/quadrature.h"

namespace splitsum {
namespace {

constexpr double pi = std::numbers::pi;

// The horizon enters and leaves a patch at an angle, which the rule in theta cannot see: patches on
// it are made this low (radians), where that costs less than 1e-7 of the integral.
constexpr double horizon_rows = 0.0125;

struct Rules {
    QuadratureRule few = gauss_legendre(3);
    QuadratureRule many = gauss_legendre(6);
};

// (extent / 4 distance)^(2 n) is below 1e-9 for both.
const QuadratureRule& rule_for(double extent, double distance) {
    static const Rules rules;
    return extent < 0.1 * distance ? rules.few : rules.many;
}

double square(double x) { return x * x; }

// 1 - cos of the angle between (theta, azimuth) and (lobe_theta, 0), by haversines.
double versine_between(double theta, double lobe_theta, double azimuth) {
    return 2 * square(std::sin(0.5 * (theta - lobe_theta))) +
           2 * std::sin(theta) * std::sin(lobe_theta) * square(std::sin(0.5 * azimuth));
}

// The azimuth at which the circle of polar angle theta meets the lobe's horizon: pi if all of the
// circle is above it, 0 if none is.
double horizon_azimuth(double theta, double lobe_theta) {
    const double along = std::sin(theta) * std::sin(lobe_theta);
    const double constant = std::cos(theta) * std::cos(lobe_theta);
    if (constant >= along) return pi;
    if (constant <= -along) return 0;
    return std::acos(-constant / along);
}

double integral_by_rules(const Lobe& lobe, double lobe_theta, const LatLongPatch& patch,
                         const QuadratureRule& down, const QuadratureRule& around) {
    return integrate(down, patch.theta0, patch.theta1, [&](double theta) {
        const double horizon = horizon_azimuth(theta, lobe_theta);
        double from = patch.azimuth0, to = patch.azimuth1;
        if (horizon < pi) {
            from = std::max(from, -horizon);
            to = std::min(to, horizon);
            if (to <= from) return 0.0;
        }
        return std::sin(theta) * integrate(around, from, to, [&](double azimuth) {
                   return lobe_value(lobe, versine_between(theta, lobe_theta, azimuth));
               });
    });
}

}  // namespace

double lobe_over_patch(const Lobe& lobe, double lobe_theta, const LatLongPatch& patch) {
    const double middle_theta = 0.5 * (patch.theta0 + patch.theta1);
    const double middle_azimuth = 0.5 * (patch.azimuth0 + patch.azimuth1);
    const double versine = versine_between(middle_theta, lobe_theta, middle_azimuth);
    const double down = patch.theta1 - patch.theta0;
    const double around =
        (patch.azimuth1 - patch.azimuth0) *
        std::sin(std::clamp(0.5 * pi, patch.theta0, patch.theta1));  // at the widest row
    const double radius = 0.5 * std::hypot(down, around);
    const double away =
        std::max(0.0, 2 * std::asin(std::min(1.0, std::sqrt(0.5 * versine))) - radius);
    const double distance = std::hypot(away, lobe_width(lobe));

    const bool on_horizon = std::abs(1 - versine) < radius && down > horizon_rows;
    if ((down > 0.5 * distance && down >= around) || on_horizon)
        return lobe_over_patch(lobe, lobe_theta,
                               {patch.theta0, middle_theta, patch.azimuth0, patch.azimuth1}) +
               lobe_over_patch(lobe, lobe_theta,
                               {middle_theta, patch.theta1, patch.azimuth0, patch.azimuth1});
    if (around > 0.5 * distance)
        return lobe_over_patch(lobe, lobe_theta,
                               {patch.theta0, patch.theta1, patch.azimuth0, middle_azimuth}) +
               lobe_over_patch(lobe, lobe_theta,
                               {patch.theta0, patch.theta1, middle_azimuth, patch.azimuth1});
    return integral_by_rules(lobe, lobe_theta, patch, rule_for(down, distance),
                             rule_for(around, distance));
}

}  // namespace splitsum
