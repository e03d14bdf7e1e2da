// The lookups themselves: what the assets hold towards a direction or at table coordinates. GLSL 4.50
// and ES 3.00.
//
// Every texture has a linear filter, clamps to the edge and, the specular cubemap, has a linear mip
// filter; desktop GL needs GL_TEXTURE_CUBE_MAP_SEAMLESS. The C++ twins are trilinear_lookup of
// lib/splitsum/verify/reconstruction.h, lib/splitsum/sphere/cubemap_lookup.h and
// lib/splitsum/table/bilinear.h; tests/shaders compares them.
//
// Languages without combined samplers: define SPLITSUM_SEPARATE_SAMPLERS, and declare one sampler for
// all, `splitsum_filter`, before this file.
#ifndef SPLITSUM_SAMPLING_GLSL
#define SPLITSUM_SAMPLING_GLSL

#ifdef SPLITSUM_SEPARATE_SAMPLERS
#define SPLITSUM_CUBE textureCube
#define SPLITSUM_TABLE texture2D
#define SPLITSUM_TABLE_ARRAY texture2DArray
#define SPLITSUM_READ_CUBE(cube) samplerCube(cube, splitsum_filter)
#define SPLITSUM_READ_TABLE(table) sampler2D(table, splitsum_filter)
#define SPLITSUM_READ_TABLE_ARRAY(tables) sampler2DArray(tables, splitsum_filter)
#else
// ES samples in low precision unless told otherwise.
#define SPLITSUM_CUBE highp samplerCube
#define SPLITSUM_TABLE highp sampler2D
#define SPLITSUM_TABLE_ARRAY highp sampler2DArray
#define SPLITSUM_READ_CUBE(cube) cube
#define SPLITSUM_READ_TABLE(table) table
#define SPLITSUM_READ_TABLE_ARRAY(tables) tables
#endif

// Radiance around a reflection direction in the cube's axes, of any length but 0, averaged for the
// roughness of `level` (splitsum_levels.glsl). Multiply by the reflectance.
vec3 splitsum_specular_light(SPLITSUM_CUBE levels, vec3 direction, float level) {
    return textureLod(SPLITSUM_READ_CUBE(levels), direction, level).rgb;
}

// E / pi towards a normal in the cube's axes. Multiply by the albedo.
vec3 splitsum_irradiance_over_pi(SPLITSUM_CUBE irradiance, vec3 normal) {
    return textureLod(SPLITSUM_READ_CUBE(irradiance), normal, 0.0).rgb;
}

// Any table of one layer, at splitsum_table_coordinates or splitsum_edge_coordinates.
vec4 splitsum_read_table(SPLITSUM_TABLE table, vec2 coordinates) {
    return textureLod(SPLITSUM_READ_TABLE(table), coordinates, 0.0);
}

// Layer 0 or 1 of a table for area lights, at splitsum_ltc_coordinates.
vec4 splitsum_read_ltc(SPLITSUM_TABLE_ARRAY tables, vec2 coordinates, float layer) {
    return textureLod(SPLITSUM_READ_TABLE_ARRAY(tables), vec3(coordinates, layer), 0.0);
}

#endif
