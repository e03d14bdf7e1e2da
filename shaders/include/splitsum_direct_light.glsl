// Light from one direction, such as a sun that was taken out of the panorama. GLSL 4.50 and ES 3.00.
//
// The BRDF of the tables: GGX, height-correlated Smith, Schlick's Fresnel. Unit vectors, all from the
// surface away. What is returned is BRDF times n·l: times the illuminance across the light's
// direction (lux where radiance is in cd/m²) it is the radiance towards the viewer. The C++ twin is
// lib/splitsum/shading/direct_light.h; tests/shaders compares the two.
#ifndef SPLITSUM_DIRECT_LIGHT_GLSL
#define SPLITSUM_DIRECT_LIGHT_GLSL

// Mean angular radius of the sun from Earth, in radians.
const float splitsum_sun_radius = 0.004653;

// The square of the lobe's width under a light whose disc has this angular radius, in radians; 0 for a
// light without extent. The highlight's peak is that of the disc, its energy is kept; the twin has
// the derivation. In [1e-8, 1].
float splitsum_alpha2_under_sun(float perceptual_roughness, float angular_radius) {
    float alpha = perceptual_roughness * perceptual_roughness;
    return clamp(alpha * alpha + 0.25 * angular_radius * angular_radius, 1e-8, 1.0);
}

// Diffuse light of an albedo of 1: n·l / pi.
float splitsum_direct_diffuse(vec3 normal, vec3 towards_light) {
    return max(dot(normal, towards_light), 0.0) * 0.31830988618;
}

// D per steradian from sin² of the angle to the normal (Walter et al. 2007, eq. 33).
float splitsum_ggx_density(float sin2_theta, float alpha2) {
    float denominator = (1.0 - sin2_theta) * alpha2 + sin2_theta;
    return alpha2 * 0.31830988618 / (denominator * denominator);
}

// V = G / (4 n·l n·v), height-correlated (Heitz 2014, eq. 99). Cosines in (0, 1].
float splitsum_smith_visibility(float n_dot_l, float n_dot_v, float alpha2) {
    float view_part = n_dot_l * sqrt(n_dot_v * n_dot_v * (1.0 - alpha2) + alpha2);
    float light_part = n_dot_v * sqrt(n_dot_l * n_dot_l * (1.0 - alpha2) + alpha2);
    return 0.5 / (view_part + light_part);
}

// D V F n·l. The peak is of order 1 / alpha2: more than half floats hold below alpha2 = 5e-6. The
// sine comes from a cross product, as 1 - cos² has no digits left in narrow lobes.
vec3 splitsum_direct_specular(vec3 normal, vec3 view, vec3 towards_light, vec3 f0, float alpha2) {
    float n_dot_l = dot(normal, towards_light);
    if (n_dot_l <= 0.0) return vec3(0.0);
    float n_dot_v = max(dot(normal, view), 1e-4);
    vec3 between = towards_light + view;
    float length2 = max(dot(between, between), 1e-12);
    vec3 across = cross(normal, between);
    float v_dot_h = clamp(dot(view, between) * inversesqrt(length2), 0.0, 1.0);
    float lobe = splitsum_ggx_density(min(dot(across, across) / length2, 1.0), alpha2) *
                 splitsum_smith_visibility(n_dot_l, n_dot_v, alpha2) * n_dot_l;
    float missing = 1.0 - v_dot_h;
    float missing2 = missing * missing;
    return lobe * (f0 + missing2 * missing2 * missing * (vec3(1.0) - f0));
}

#endif
