#include "splitsum/brdf/lambert.h"

#include <cmath>
#include <numbers>

namespace splitsum {

double cosine_direction_pdf(double cos_theta) {
    return cos_theta > 0 ? cos_theta * std::numbers::inv_pi : 0;
}

Vec3d sample_cosine_direction(const Vec2d& u) {
    const double sin_theta = std::sqrt(u.x);
    const double phi = 2 * std::numbers::pi * u.y;
    return {sin_theta * std::cos(phi), sin_theta * std::sin(phi), std::sqrt(1 - u.x)};
}

}  // namespace splitsum
