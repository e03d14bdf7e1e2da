#include "splitsum/sphere/cubemap.h"

#include <cmath>
#include <numbers>

namespace splitsum {
namespace {

// The integral of the solid angle over [0, x] x [0, y] of the plane at distance 1.
double corner_solid_angle(double x, double y) {
    return std::atan2(x * y, std::sqrt(x * x + y * y + 1));
}

}  // namespace

Vec3d direction_on_face(int face, double s, double t) {
    const double a = 2 * s - 1;  // right
    const double b = 2 * t - 1;  // down
    switch (face) {
        case 0: return normalize(Vec3d(1, -b, -a));
        case 1: return normalize(Vec3d(-1, -b, a));
        case 2: return normalize(Vec3d(a, 1, b));
        case 3: return normalize(Vec3d(a, -1, -b));
        case 4: return normalize(Vec3d(a, -b, 1));
        default: return normalize(Vec3d(-a, -b, -1));
    }
}

double solid_angle_of_texel(int x, int y, int face_size) {
    const double left = 2.0 * x / face_size - 1, right = 2.0 * (x + 1) / face_size - 1;
    const double top = 2.0 * y / face_size - 1, bottom = 2.0 * (y + 1) / face_size - 1;
    return corner_solid_angle(right, bottom) - corner_solid_angle(left, bottom) -
           corner_solid_angle(right, top) + corner_solid_angle(left, top);
}

FacePoint face_point_towards(const Vec3d& d) {
    const double x = std::abs(d.x), y = std::abs(d.y), z = std::abs(d.z);
    const auto on = [](int face, double right, double down, double major) {
        return FacePoint{face, 0.5 * (right / major + 1), 0.5 * (down / major + 1)};
    };
    if (x >= y && x >= z) return d.x > 0 ? on(0, -d.z, -d.y, x) : on(1, d.z, -d.y, x);
    if (y >= z) return d.y > 0 ? on(2, d.x, d.z, y) : on(3, d.x, -d.z, y);
    return d.z > 0 ? on(4, d.x, -d.y, z) : on(5, -d.x, -d.y, z);
}

Vec3d mean_radiance(const Cubemap& cubemap) {
    Vec3d sum(0);
    for (int y = 0; y < cubemap.face_size; ++y)
        for (int x = 0; x < cubemap.face_size; ++x) {
            const double weight = solid_angle_of_texel(x, y, cubemap.face_size);
            for (int face = 0; face < face_count; ++face)
                sum += weight * Vec3d(cubemap.at(face, x, y));
        }
    return sum / (4 * std::numbers::pi);
}

}  // namespace splitsum
