#include "splitsum/brdf/polygon.h"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace splitsum {

std::vector<Vec3d> clip_to_horizon(std::span<const Vec3d> polygon) {
    std::vector<Vec3d> above;
    above.reserve(polygon.size() + 1);
    for (size_t i = 0; i < polygon.size(); ++i) {
        const Vec3d& from = polygon[i];
        const Vec3d& to = polygon[(i + 1) % polygon.size()];
        if (from.z > 0) above.push_back(from);
        if ((from.z > 0) == (to.z > 0)) continue;
        const Vec3d crossing = from + from.z / (from.z - to.z) * (to - from);
        above.emplace_back(crossing.x, crossing.y, 0);
    }
    return above;
}

double polygon_form_factor(std::span<const Vec3d> polygon) {
    if (polygon.size() < 3) return 0;
    double sum = 0;
    for (size_t i = 0; i < polygon.size(); ++i) {
        const Vec3d from = normalize(polygon[i]);
        const Vec3d to = normalize(polygon[(i + 1) % polygon.size()]);
        const Vec3d normal = cross(from, to);
        const double sine = length(normal);
        if (sine > 0) sum += std::atan2(sine, dot(from, to)) * (normal.z / sine);
    }
    return std::abs(sum) * 0.5 * std::numbers::inv_pi;
}

}  // namespace splitsum
