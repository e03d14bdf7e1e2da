#include "splitsum/brdf/visible_normals.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/brdf/ggx.h"
#include "splitsum/brdf/smith.h"

namespace splitsum {

double visible_normal_pdf(const Vec3d& view, const Vec3d& normal, double alpha) {
    if (normal.z <= 0) return 0;
    const double sin2_theta = normal.x * normal.x + normal.y * normal.y;
    return smith_masking(view.z, alpha) * std::max(0.0, dot(view, normal)) *
           ggx_density(sin2_theta, alpha) / view.z;
}

// Stretched by 1 / alpha the surface is a hemisphere, and a ray reflected by it leaves uniformly
// over the cap z >= -w.z around the stretched view w; the normal is half way between the two.
Vec3d sample_visible_normal(const Vec3d& view, const Vec2d& u, double alpha) {
    const Vec3d stretched = normalize(Vec3d(alpha * view.x, alpha * view.y, view.z));
    const double height = 1 + stretched.z;  // of the cap
    // (1 - z)(1 + z) for z = (1 - u.x) height - w.z, with 1 - w.z from the sine of w.
    const double sin2_stretched = stretched.x * stretched.x + stretched.y * stretched.y;
    const double sin2_theta = u.x * height * ((1 - u.x) * height + sin2_stretched / height);
    const double sin_theta = std::sqrt(sin2_theta);
    const double phi = 2 * std::numbers::pi * u.y;
    return normalize(Vec3d(alpha * (sin_theta * std::cos(phi) + stretched.x),
                           alpha * (sin_theta * std::sin(phi) + stretched.y), (1 - u.x) * height));
}

}  // namespace splitsum
