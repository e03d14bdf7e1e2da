// Which way a world direction lies in the cubemaps. GLSL 4.50 and ES 3.00.
//
// Cubemaps are left-handed with +y up; each renderer's directions take one of these ways there, and
// every way is its own inverse. Vectors of any length. The C++ twin is
// lib/splitsum/shading/directions.h; tests/shaders compares the two.
#ifndef SPLITSUM_DIRECTIONS_GLSL
#define SPLITSUM_DIRECTIONS_GLSL

// World axes with +z ahead and +x right.
vec3 splitsum_cube_from_left_handed(vec3 direction) {
    return direction;
}

// World axes of a viewer that looks down -z: Bevy, glTF viewers, Babylon's right-handed scenes.
vec3 splitsum_cube_from_right_handed(vec3 direction) {
    return vec3(direction.xy, -direction.z);
}

// three.js and PlayCanvas, which mirror x.
vec3 splitsum_cube_from_three(vec3 direction) {
    return vec3(-direction.x, direction.yz);
}

// Where to look when the environment is turned about +y at run time, from +z towards +x, as --rotate
// does at bake time. For directions of all cubemaps and of the harmonics.
vec3 splitsum_turned_environment(vec3 cube_direction, float radians_about_y) {
    float sine = sin(radians_about_y);
    float cosine = cos(radians_about_y);
    return vec3(cube_direction.x * cosine - cube_direction.z * sine, cube_direction.y,
                cube_direction.x * sine + cube_direction.z * cosine);
}

#endif
