// How the split-sum table is read and used. GLSL 4.50 and ES 3.00.
//
// The table's red is a and its green is b: under constant light a surface reflects F0 a + b. Texel
// (x, y) holds n·v = (x + 1/2) / size and perceptual roughness (y + 1/2) / size, which is where a
// sampler puts texel centres, so texture coordinates are the two values themselves. Sample with a
// linear filter and clamp to the edge: outside of the first and last centre, half a texel, the table
// is constant. The C++ twin is lib/splitsum/table/split_sum_lookup.h; tests/shaders compares the two.
#ifndef SPLITSUM_SPLIT_SUM_GLSL
#define SPLITSUM_SPLIT_SUM_GLSL

// Where the table is sampled.
vec2 splitsum_table_coordinates(float n_dot_v, float perceptual_roughness) {
    return vec2(clamp(n_dot_v, 0.0, 1.0), clamp(perceptual_roughness, 0.0, 1.0));
}

// The same for a table with texels exactly at 0 and at 1 (--layout edge), `size` along an edge: the
// texture coordinates of what splitsum_table_coordinates returned.
vec2 splitsum_edge_coordinates(vec2 coordinates, float size) {
    float half_texel = 0.5 / size;
    float covered = 1.0 - 2.0 * half_texel;
    return coordinates * covered + vec2(half_texel);
}

// Share of uniform light that is reflected in one bounce, per channel of F0.
vec3 splitsum_directional_albedo(vec3 f0, vec2 split_sum) {
    return f0 * split_sum.x + split_sum.y;
}

// The same from a table `ggx-multiscatter`, whose red is b and whose green is a + b.
vec3 splitsum_directional_albedo_of_multiscatter(vec3 f0, vec2 multiscatter) {
    return vec3(multiscatter.x) + f0 * (multiscatter.y - multiscatter.x);
}

// What single-bounce light is multiplied with so that no energy is lost between the microfacets: a
// surface with F0 = 1 then returns all of a white furnace (Turquin 2019, "Practical multiple
// scattering compensation for microfacet models").
vec3 splitsum_energy_compensation(vec3 f0, vec2 split_sum) {
    float lost_per_returned = 1.0 / (split_sum.x + split_sum.y) - 1.0;
    return vec3(1.0) + f0 * lost_per_returned;
}

// The same from a table `ggx-multiscatter`.
vec3 splitsum_energy_compensation_of_multiscatter(vec3 f0, vec2 multiscatter) {
    float lost_per_returned = 1.0 / multiscatter.y - 1.0;
    return vec3(1.0) + f0 * lost_per_returned;
}

// What the surface reflects of uniform light with all bounces, in [0, 1]: what prefiltered light is
// multiplied with.
vec3 splitsum_reflectance(vec3 f0, vec2 split_sum) {
    return splitsum_directional_albedo(f0, split_sum) * splitsum_energy_compensation(f0, split_sum);
}

// What light between the microfacets adds to the BRDF of a perfect reflector, from a table `energy`
// (red: E, green: its average) read for the view and for the light (Kulla & Conty 2017).
float splitsum_multiple_scattering(float energy_view, float energy_light, float average_energy) {
    float inverse_pi = 0.31830988618;
    float lost_on_average = max(1.0 - average_energy, 1e-6);
    return (1.0 - energy_view) * (1.0 - energy_light) * inverse_pi / lost_on_average;
}

// The same from a table `energy-lost` (red: 1 - E, green: its average), which keeps its digits on smooth
// surfaces.
float splitsum_multiple_scattering_of_lost(float lost_view, float lost_light, float average_lost) {
    float inverse_pi = 0.31830988618;
    return lost_view * lost_light * inverse_pi / max(average_lost, 1e-20);
}

#endif
