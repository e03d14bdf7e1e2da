#include "splitsum/shading/direct_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/brdf/ggx.h"
#include "splitsum/brdf/smith.h"

namespace splitsum {

double direct_diffuse(const Vec3d& normal, const Vec3d& towards_light) {
    return std::max(dot(normal, towards_light), 0.0) * std::numbers::inv_pi;
}

Vec3d direct_specular(const Vec3d& normal, const Vec3d& view, const Vec3d& towards_light,
                      const Vec3d& f0, double alpha2) {
    const double n_dot_l = dot(normal, towards_light);
    if (n_dot_l <= 0) return Vec3d(0);
    const double n_dot_v = std::max(dot(normal, view), 1e-4);
    // The sine by the cross product: 1 - cos² has no digits left in narrow lobes.
    const Vec3d half = towards_light + view;
    const double length2 = std::max(dot(half, half), 1e-12);
    const Vec3d across = cross(normal, half);
    const double v_dot_h = std::clamp(dot(view, half) / std::sqrt(length2), 0.0, 1.0);
    const double alpha = std::sqrt(alpha2);
    const double lobe = ggx_density(std::min(dot(across, across) / length2, 1.0), alpha) *
                        smith_visibility(SmithTerm::height_correlated, n_dot_l, n_dot_v, alpha) *
                        n_dot_l;
    const double grazing = std::pow(1 - v_dot_h, 5);
    return lobe * (f0 + grazing * (Vec3d(1) - f0));
}

double alpha2_under_sun(double perceptual_roughness, double angular_radius) {
    const double alpha = perceptual_roughness * perceptual_roughness;
    return std::clamp(alpha * alpha + 0.25 * angular_radius * angular_radius, 1e-8, 1.0);
}

}  // namespace splitsum
