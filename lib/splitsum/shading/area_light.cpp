#include "splitsum/shading/area_light.h"

#include <algorithm>

#include "splitsum/ltc/polygon_light.h"

namespace splitsum {
namespace {

bool shows_its_lit_side(const LightCorners& corners) {
    const Vec3d facing = cross(corners[1] - corners[0], corners[3] - corners[0]);
    return dot(facing, corners[0]) < 0;
}

}  // namespace

Mat3d light_frame(const Vec3d& normal, const Vec3d& view) {
    const Vec3d side = view - dot(normal, view) * normal;
    const Vec3d x = dot(side, side) < 1e-12 ? basis_around(normal).tangent : normalize(side);
    const Vec3d y = cross(normal, x);
    return {x.x, y.x, normal.x, x.y, y.y, normal.y, x.z, y.z, normal.z};
}

double area_light(const LtcInverse& inverse, const Mat3d& frame, const LightCorners& corners,
                  bool two_sided) {
    if (!two_sided && !shows_its_lit_side(corners)) return 0;
    LightCorners seen;
    std::ranges::transform(corners, seen.begin(), [&](const Vec3d& c) { return frame * c; });
    return ltc_polygon_light(inverse, seen);
}

}  // namespace splitsum
