#include "splitsum/brdf/ggx.h"

#include <cmath>
#include <numbers>

namespace splitsum {

double ggx_density(double sin2_theta, double alpha) {
    const double alpha2 = alpha * alpha;
    const double denominator = (1 - sin2_theta) * alpha2 + sin2_theta;
    return alpha2 / (std::numbers::pi * denominator * denominator);
}

double ggx_normal_pdf(const Vec3d& normal, double alpha) {
    if (normal.z <= 0) return 0;
    return normal.z * ggx_density(normal.x * normal.x + normal.y * normal.y, alpha);
}

GgxNormal sample_ggx_normal(const Vec2d& u, double alpha) {
    const double alpha2 = alpha * alpha;
    const double inverse = 1 / ((1 - u.x) + alpha2 * u.x);
    const double sin2_theta = alpha2 * u.x * inverse;
    const double sin_theta = std::sqrt(sin2_theta);
    const double phi = 2 * std::numbers::pi * u.y;
    return {{sin_theta * std::cos(phi), sin_theta * std::sin(phi), std::sqrt((1 - u.x) * inverse)},
            sin2_theta};
}

}  // namespace splitsum
