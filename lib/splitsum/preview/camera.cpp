#include "splitsum/preview/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace splitsum {
namespace {

constexpr double radians = std::numbers::pi / 180;

Mat3d turn(double yaw, double pitch) {
    const double cy = std::cos(yaw), sy = std::sin(yaw), cp = std::cos(pitch), sp = std::sin(pitch);
    return {Vec3d(cy, 0, -sy), Vec3d(-sy * sp, cp, -cy * sp), Vec3d(sy * cp, sp, cy * cp)};
}

struct Box {
    Vec3d low{std::numeric_limits<double>::infinity()};
    Vec3d high{-std::numeric_limits<double>::infinity()};
};

Box bounds(const Scene& scene) {
    Box box;
    for (const Sphere& sphere : scene.spheres) {
        box.low = min(box.low, sphere.centre - Vec3d(sphere.radius));
        box.high = max(box.high, sphere.centre + Vec3d(sphere.radius));
    }
    return box;
}

// How far before `across`, the sphere's distance from the axis, a camera whose half field has this
// tangent must stand for the sphere to touch the edge of the picture.
double distance_to_see(double across, double radius, double tangent) {
    return (across + radius * std::sqrt(1 + tangent * tangent)) / tangent;
}

}  // namespace

Camera camera_for(const Scene& scene, const Viewpoint& viewpoint) {
    constexpr double margin = 1.04;
    const Box box = bounds(scene);
    const Vec3d middle = 0.5 * (box.low + box.high);
    const double up = std::tan(0.5 * vertical_field_degrees * radians);
    const double right = up * viewpoint.width / viewpoint.height;
    double z = std::numeric_limits<double>::infinity();
    for (const Sphere& sphere : scene.spheres) {
        const Vec3d across = abs(sphere.centre - middle);
        const double radius = margin * sphere.radius;
        z = std::min(z, sphere.centre.z - std::max(distance_to_see(across.x, radius, right),
                                                   distance_to_see(across.y, radius, up)));
    }
    return {viewpoint.width, viewpoint.height, up, Vec3d(middle.x, middle.y, z),
            turn(viewpoint.yaw_degrees * radians, viewpoint.pitch_degrees * radians)};
}

Vec3d ray_through(const Camera& camera, int x, int y) {
    const double per_pixel = 2 * camera.tan_half_height / camera.height;
    return normalize(Vec3d((x + 0.5 - 0.5 * camera.width) * per_pixel,
                           (0.5 * camera.height - y - 0.5) * per_pixel, 1));
}

std::optional<SeenSurface> first_surface(const Scene& scene, const Camera& camera, int x, int y) {
    const Vec3d ray = ray_through(camera, x, y);
    double nearest = std::numeric_limits<double>::infinity();
    std::optional<SeenSurface> seen;
    for (size_t i = 0; i < scene.spheres.size(); ++i) {
        const Sphere& sphere = scene.spheres[i];
        const Vec3d offset = sphere.centre - camera.position;
        const double along = dot(offset, ray);
        const Vec3d closest = offset - along * ray;  // from the ray to the centre
        const double depth2 = sphere.radius * sphere.radius - dot(closest, closest);
        if (depth2 < 0) continue;
        const double distance = along - std::sqrt(depth2);
        if (distance <= 0 || distance >= nearest) continue;
        nearest = distance;
        const Vec3d normal = (distance * ray - offset) / sphere.radius;
        seen = SeenSurface{int(i), normalize(camera.cube_from_view * normal),
                           camera.cube_from_view * -ray};
    }
    return seen;
}

}  // namespace splitsum
