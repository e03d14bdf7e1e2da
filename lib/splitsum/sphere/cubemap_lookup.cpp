#include "splitsum/sphere/cubemap_lookup.h"

#include <algorithm>
#include <cmath>

namespace splitsum {
namespace {

/// Texel (x, y) of a face; one step beyond its edge, the texel of the next face that lies there.
const Vec3& texel_beyond(const Cubemap& cubemap, int face, int x, int y) {
    const int last = cubemap.face_size - 1;
    const FacePoint beyond = face_point_towards(direction_of_texel(face, x, y, cubemap.face_size));
    const auto texel = [&](double at) {
        return std::clamp(static_cast<int>(at * cubemap.face_size), 0, last);
    };
    return cubemap.at(beyond.face, texel(beyond.s), texel(beyond.t));
}

Vec3 texel_near(const Cubemap& cubemap, int face, int x, int y) {
    const int last = cubemap.face_size - 1;
    const int inner_x = std::clamp(x, 0, last), inner_y = std::clamp(y, 0, last);
    if (x == inner_x && y == inner_y) return cubemap.at(face, x, y);
    if (x == inner_x || y == inner_y) return texel_beyond(cubemap, face, x, y);
    // Three texels meet at a corner; hardware takes their mean for the fourth.
    return (cubemap.at(face, inner_x, inner_y) + texel_beyond(cubemap, face, x, inner_y) +
            texel_beyond(cubemap, face, inner_x, y)) /
           3.0f;
}

}  // namespace

Vec3 bilinear_lookup(const Cubemap& cubemap, const Vec3d& direction) {
    const FacePoint point = face_point_towards(direction);
    const double s = point.s * cubemap.face_size - 0.5, t = point.t * cubemap.face_size - 0.5;
    const int x = static_cast<int>(std::floor(s)), y = static_cast<int>(std::floor(t));
    const float right = static_cast<float>(s - x), below = static_cast<float>(t - y);
    const auto row = [&](int at_y) {
        return (1 - right) * texel_near(cubemap, point.face, x, at_y) +
               right * texel_near(cubemap, point.face, x + 1, at_y);
    };
    return (1 - below) * row(y) + below * row(y + 1);
}

}  // namespace splitsum
