#include "splitsum/ltc/clipped_sphere.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace splitsum {

// The form factor of a region of the sky is z of (1 / 2 pi) ∮ r x dr around its outline. Here that is
// the part of the sphere's circle above the horizon, azimuths -psi to psi about its topmost point,
//     r x dr . z = sin s (sin s cos c - cos s cos azimuth sin c) d azimuth,
// with s its angular radius and c the angle to its centre, and the arc of horizon inside the sphere,
// of which the angle counts as it is.
double clipped_sphere_ratio(double cos_to_centre, double form_factor) {
    const double cos_c = std::clamp(cos_to_centre, -1.0, 1.0);
    const double sin_c = std::sqrt((1 - cos_c) * (1 + cos_c));
    const double sin_s = std::sqrt(std::clamp(form_factor, 1e-12, 1.0));
    const double cos_s = std::sqrt((1 - sin_s) * (1 + sin_s));
    if (cos_s * std::abs(cos_c) >= sin_s * sin_c) return std::max(cos_c, 0.0);
    const double cos_psi = -(cos_s * cos_c) / (sin_s * sin_c);
    const double psi = std::acos(cos_psi);
    const double sin_psi = std::sqrt((1 - cos_psi) * (1 + cos_psi));
    const double along = cos_s * sin_c - sin_s * cos_c * cos_psi;
    const double horizon = std::atan2(sin_s * sin_psi, along);
    const double outline = sin_s * (psi * sin_s * cos_c - cos_s * sin_psi * sin_c);
    return (outline + horizon) * std::numbers::inv_pi / (sin_s * sin_s);
}

}  // namespace splitsum
