#include "splitsum/preview/auto_yaw.h"

#include <cmath>
#include <numbers>

#include "splitsum/image/luminance.h"

namespace splitsum {

double auto_yaw_degrees(const Cubemap& irradiance) {
    constexpr double light_from_left = 110;  // degrees from where the viewer looks
    constexpr double step = 5;
    constexpr double even = 0.02;  // of all light
    const int size = irradiance.face_size;
    Vec3d sum(0);
    double all = 0;
    for (int face = 0; face < face_count; ++face)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const double light =
                    luminance(Vec3d(irradiance.at(face, x, y))) * solid_angle_of_texel(x, y, size);
                sum += light * direction_of_texel(face, x, y, size);
                all += light;
            }
    if (std::hypot(sum.x, sum.z) <= even * all) return 0;
    const double azimuth = std::atan2(sum.x, sum.z) * 180 / std::numbers::pi;
    return std::remainder(step * std::round((azimuth + light_from_left) / step), 360.0);
}

}  // namespace splitsum
