#include "splitsum/shading/directions.h"

#include <cmath>

namespace splitsum {

Vec3d cube_from_world(WorldAxes axes, const Vec3d& direction) {
    switch (axes) {
        case WorldAxes::left_handed: break;
        case WorldAxes::right_handed: return {direction.x, direction.y, -direction.z};
        case WorldAxes::three: return {-direction.x, direction.y, direction.z};
    }
    return direction;
}

// What is seen at azimuth a (sin a = x, cos a = z) was at a - radians before the turn.
Vec3d turned_environment(const Vec3d& d, double radians) {
    const double sine = std::sin(radians), cosine = std::cos(radians);
    return {d.x * cosine - d.z * sine, d.y, d.x * sine + d.z * cosine};
}

}  // namespace splitsum
