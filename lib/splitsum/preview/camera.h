#pragma once

#include <optional>

#include "splitsum/math/vec.h"
#include "splitsum/preview/scene.h"

namespace splitsum {

/// From where a scene is seen.
struct Viewpoint {
    int width = 1024;  ///< of the picture in pixels, > 0
    int height = 512;
    double yaw_degrees = 0;    ///< the view turned about +y, from +z towards +x
    double pitch_degrees = 0;  ///< then looking up by this; in [-90, 90]
};

/// A perspective camera that has the whole scene in sight, with square pixels and a vertical field
/// of view of vertical_field_degrees. The page's camera is the same (page/camera.glsl).
///
/// The view is turned in the cube's axes (sphere/cubemap.h: left-handed, +y up): at yaw 0, pitch 0
/// it looks along +z with +x to the right.
struct Camera {
    int width;
    int height;
    double tan_half_height;  ///< of half the vertical field of view
    Vec3d position;          ///< in view axes, as the spheres are
    Mat3d cube_from_view;    ///< a rotation
};

inline constexpr double vertical_field_degrees = 20;

/// A camera on the axis through the middle of the scene's bounding box, as near as it can be with a
/// margin of 4 % around every sphere. The scene must have a sphere.
Camera camera_for(const Scene& scene, const Viewpoint& viewpoint);

/// The unit direction through the centre of pixel (x, y), in view axes; rows count from the top.
Vec3d ray_through(const Camera& camera, int x, int y);

/// What is seen at a pixel's centre; directions are unit vectors in the cube's axes.
struct SeenSurface {
    int sphere;    ///< index into the scene
    Vec3d normal;  ///< outwards
    Vec3d view;    ///< from the surface to the camera
};

/// The nearest sphere at a pixel's centre, or nothing where the background is seen. One sample a
/// pixel, at the centre, so that every renderer agrees on which pixels are which sphere's.
std::optional<SeenSurface> first_surface(const Scene& scene, const Camera& camera, int x, int y);

}  // namespace splitsum
