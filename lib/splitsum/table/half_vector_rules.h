#pragma once

#include <vector>

#include "splitsum/math/quadrature.h"

namespace splitsum {

// Quadrature rules over the half vectors whose light is above the horizon.
//
// With the view in the plane phi = 0 and s = sin theta_v, light and half vector are tied by
//     n·l = 2 (v·h) (n·h) - n·v = s cos(phi) sin(2 theta) + n·v cos(2 theta),
// a single cosine of 2 theta with amplitude R = sqrt(s² cos² phi + n·v²). So at every azimuth the
// light is above the horizon exactly for theta < theta_max = pi / 4 + atan2(s cos phi, n·v) / 2, and
// inside of that boundary the integrand is analytic: rules that end at it converge exponentially.
// (A rule over visible normals, whose square the horizon cuts, reaches 2e-3 with 32 x 32 nodes and
// 5e-4 with 64 x 64.)
//
// What limits the convergence are poles and branch points near the real axis: within alpha of
// theta = 0 (the lobe), within min(alpha, n·v) of the horizon (shadowing), within n·v of
// phi = pi / 2, where at grazing views the horizon crosses the lobe. Near each of them distances are
// mapped by d = e sinh(u asinh(L / e)), e the distance of the singularity and L the length: in u
// the nearest one is then pi / 2 away from an interval of length T = asinh(L / e), so the number of
// Gauss points for an error t grows as T ln(1 / t).

/// Nodes in (0, 1) and weights for the integral over tan(theta / 2) / tan(theta_max / 2), padded with
/// nodes of weight 0 to a multiple of polar_padding.
struct PolarRule {
    std::vector<double> nodes;
    std::vector<double> weights;
};
inline constexpr int polar_padding = 8;

/// One azimuth of a rule over [0, pi].
struct Azimuth {
    double across;   ///< sin theta_v cos phi
    double horizon;  ///< tan(theta_max / 2)
    double weight;   ///< for dphi over both halves of the circle, so twice that of [0, pi]
};

struct AzimuthRule {
    double n_dot_v = 1;
    std::vector<Azimuth> azimuths;
};

/// The Gauss-Legendre rules that the functions below are made of, each computed once. Cost: 1 ms.
class GaussRules {
public:
    GaussRules();

    /// The rule with at least `nodes` nodes, or the largest there is.
    const QuadratureRule& with(double nodes) const;

private:
    std::vector<QuadratureRule> rules_;
};

/// The rule for a lobe of width alpha in (0, 1] whose integral over theta misses by less than
/// `tolerance` at all azimuths when the view has that n·v in [0, 1]. Rules are equal for all n·v of
/// an octave.
PolarRule polar_rule(const GaussRules& gauss, double alpha, double n_dot_v, double tolerance);

/// Which octave that is: two n·v with the same number have the same rule.
int polar_octave(double alpha, double n_dot_v);

/// The rule over azimuths for a view, for every alpha. `n_dot_v` in [0, 1].
AzimuthRule azimuth_rule(const GaussRules& gauss, double n_dot_v, double tolerance);

}  // namespace splitsum
