// How the tables `charlie`, `charlie-clamped` and `charlie-smith` are used. GLSL 4.50 and ES 3.00.
//
// The table's red is the directional albedo of cloth over (n·v, perceptual roughness), read at
// splitsum_table_coordinates (splitsum_split_sum.glsl). The C++ twin is
// lib/splitsum/table/albedo_lookup.h; tests/shaders compares the two.
#ifndef SPLITSUM_CLOTH_GLSL
#define SPLITSUM_CLOTH_GLSL

// Share of uniform light that cloth of this colour reflects, per channel: what prefiltered light is
// multiplied with.
vec3 splitsum_cloth_reflectance(vec3 sheen_color, float cloth_albedo) {
    return sheen_color * cloth_albedo;
}

// What the layers below cloth are multiplied with, so that both together return no more than comes in:
// the brightest channel decides, as KHR_materials_sheen has it (albedo scaling).
float splitsum_below_cloth(vec3 sheen_color, float cloth_albedo) {
    float brightest = max(sheen_color.x, max(sheen_color.y, sheen_color.z));
    return clamp(1.0 - brightest * cloth_albedo, 0.0, 1.0);
}

#endif
