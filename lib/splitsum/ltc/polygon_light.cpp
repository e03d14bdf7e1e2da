#include "splitsum/ltc/polygon_light.h"

#include <vector>

#include "splitsum/brdf/polygon.h"

namespace splitsum {

double ltc_polygon_light(const LtcInverse& inverse, std::span<const Vec3d> polygon) {
    std::vector<Vec3d> carried;
    carried.reserve(polygon.size());
    for (const Vec3d& corner : polygon) carried.push_back(to_cosine_space(inverse, corner));
    return polygon_form_factor(clip_to_horizon(carried));
}

}  // namespace splitsum
