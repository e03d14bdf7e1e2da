#pragma once

#include "splitsum/math/vec.h"

namespace splitsum {

// Where a renderer looks its directions up in the cubemaps: the twin of
// shaders/include/splitsum_directions.glsl. Cubemaps are left-handed with +y up (sphere/cubemap.h).

/// The world axes of a renderer, all with +y up.
enum class WorldAxes {
    left_handed,   ///< +z ahead: the cube's own
    right_handed,  ///< looks down -z: Bevy, glTF viewers, Babylon's right-handed scenes
    three,         ///< three.js and PlayCanvas, which mirror x
};

/// The cube direction of a world direction, of the same length. Each is its own inverse, so it also
/// carries cube directions, such as that of a sun found in the panorama, to the world.
Vec3d cube_from_world(WorldAxes axes, const Vec3d& direction);

/// Where to look in the cube when the environment is turned about +y at run time: by this angle,
/// from +z towards +x as Orientation::rotate_degrees counts. `cube_direction` has any length.
Vec3d turned_environment(const Vec3d& cube_direction, double radians);

}  // namespace splitsum
