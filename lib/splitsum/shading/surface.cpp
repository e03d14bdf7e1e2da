#include "splitsum/shading/surface.h"

namespace splitsum {

SurfaceResponse response_of(const Vec3d& base_color, double metalness, const SplitSum& split_sum) {
    const Vec3d f0 = f0_of(base_color, metalness);
    const auto each = [&](double (*of_channel)(const SplitSum&, double)) {
        return Vec3d(of_channel(split_sum, f0.x), of_channel(split_sum, f0.y),
                     of_channel(split_sum, f0.z));
    };
    const Vec3d reflected = each(reflectance);
    return {f0, each(energy_compensation), reflected,
            diffuse_albedo_of(base_color, metalness, reflected)};
}

}  // namespace splitsum
