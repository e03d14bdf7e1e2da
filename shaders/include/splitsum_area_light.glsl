// How the tables `ltc-ggx` and `ltc-disney` are read. GLSL 4.50 and ES 3.00.
//
// Two layers of `size` by `size` texels at the edges (--layout edge, the default of these tables),
// right: perceptual roughness, down: sqrt(1 - n·v). Sample with a linear filter and clamp to the edge.
// The C++ twin is lib/splitsum/table/ltc_lookup.h; tests/shaders compares the two.
#ifndef SPLITSUM_AREA_LIGHT_GLSL
#define SPLITSUM_AREA_LIGHT_GLSL

// Where texels at the edges hold coordinates in [0, 1].
vec2 splitsum_ltc_texels(vec2 coordinates, float size) {
    float half_texel = 0.5 / size;
    float covered = 1.0 - 2.0 * half_texel;
    return coordinates * covered + vec2(half_texel);
}

// Where both layers are sampled for a surface.
vec2 splitsum_ltc_coordinates(float n_dot_v, float perceptual_roughness, float size) {
    return splitsum_ltc_texels(vec2(clamp(perceptual_roughness, 0.0, 1.0),
                                    sqrt(1.0 - clamp(n_dot_v, 0.0, 1.0))), size);
}

// Where layer 1 is sampled, alpha alone, for the share of a sphere's form factor that the horizon
// leaves. The sphere's centre lies at this cosine from the normal; `form_factor` is that of the sphere
// facing it.
vec2 splitsum_ltc_sphere_coordinates(float cos_to_centre, float form_factor, float size) {
    return splitsum_ltc_texels(vec2(clamp(0.5 * cos_to_centre + 0.5, 0.0, 1.0),
                                    clamp(form_factor, 0.0, 1.0)), size);
}

// The matrix that carries directions to the space where the lobe is a clamped cosine, from layer 0: in
// the frame of normal (z) and the viewer's side of the surface (x).
mat3 splitsum_ltc_inverse(vec4 layer0) {
    return mat3(vec3(layer0.x, 0.0, layer0.y), vec3(0.0, 1.0, 0.0),
                vec3(layer0.z, 0.0, layer0.w));
}

// What a polygon's form factor in that space is multiplied with, from layer 1: albedo for F = 1,
// within 1 %, and the same weighted with (1 - v·h)^5 (Hill 2016, "LTC Fresnel Approximation").
vec3 splitsum_ltc_reflectance(vec3 f0, vec4 layer1) {
    return f0 * layer1.x + (vec3(1.0) - f0) * layer1.y;
}

#endif
