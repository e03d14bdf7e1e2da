// How the tables `diffuse-disney` and `diffuse-renormalised` are used. GLSL 4.50 and ES 3.00.
//
// The table's red is the directional albedo of Disney's diffuse lobe of a white surface over (n·v,
// perceptual roughness), read at splitsum_table_coordinates (splitsum_split_sum.glsl). At grazing
// views of rough surfaces `diffuse-disney` is above 1, up to 1.558: the lobe returns more than it gets.
// The C++ twin is lib/splitsum/table/albedo_lookup.h; tests/shaders compares the two.
#ifndef SPLITSUM_DIFFUSE_GLSL
#define SPLITSUM_DIFFUSE_GLSL

// Share of uniform light that a surface of this colour reflects, per channel: what the irradiance
// E / pi is multiplied with, instead of with the colour alone.
vec3 splitsum_diffuse_reflectance(vec3 base_color, float diffuse_albedo) {
    return base_color * diffuse_albedo;
}

// The same where no more than all light may come back.
vec3 splitsum_diffuse_reflectance_bounded(vec3 base_color, float diffuse_albedo) {
    return base_color * min(diffuse_albedo, 1.0);
}

#endif
