#include "splitsum/brdf/phong.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace splitsum {
namespace {

double power_of_mirror_cosine(const Vec3d& light, const Vec3d& view, double exponent) {
    if (light.z <= 0 || view.z <= 0) return 0;
    const double cosine = light.z * view.z - light.x * view.x - light.y * view.y;
    return std::pow(std::max(0.0, cosine), exponent);
}

}  // namespace

double phong_brdf(const Vec3d& light, const Vec3d& view, double exponent) {
    return light.z > 0 ? power_of_mirror_cosine(light, view, exponent) / light.z : 0;
}

double normalised_phong_brdf(const Vec3d& light, const Vec3d& view, double exponent) {
    return (exponent + 2) * 0.5 * std::numbers::inv_pi *
           power_of_mirror_cosine(light, view, exponent);
}

}  // namespace splitsum
