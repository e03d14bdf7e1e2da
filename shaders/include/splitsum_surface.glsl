// A surface of metalness and perceptual roughness under baked light. GLSL 4.50 and ES 3.00.
//
// Colours are scene-linear, in [0, 1]. The C++ twin is lib/splitsum/shading/surface.h; tests/shaders
// compares the two.
#ifndef SPLITSUM_SURFACE_GLSL
#define SPLITSUM_SURFACE_GLSL

// Reflectance at normal incidence: 0.04, an index of refraction of 1.5, for what is no metal.
vec3 splitsum_f0(vec3 base_color, float metalness) {
    return (1.0 - metalness) * vec3(0.04) + metalness * base_color;
}

// Albedo of what lies below the reflecting surface, whose reflectance is that of
// splitsum_reflectance (splitsum_split_sum.glsl). Metals have nothing there.
vec3 splitsum_diffuse_albedo(vec3 base_color, float metalness, vec3 reflectance) {
    return (1.0 - metalness) * base_color * (vec3(1.0) - reflectance);
}

// Radiance towards the viewer under an environment, from what the specular cubemap and the irradiance
// cubemap or harmonics hold.
vec3 splitsum_image_based_light(vec3 specular_light, vec3 irradiance_over_pi, vec3 reflectance,
                                vec3 diffuse_albedo) {
    return specular_light * reflectance + irradiance_over_pi * diffuse_albedo;
}

#endif
