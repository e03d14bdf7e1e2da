// Calls every function of the library once: no picture, but where translations to other languages
// find all of them.
#include "interface.glsl"
#include "splitsum_area_light.glsl"
#include "splitsum_cloth.glsl"
#include "splitsum_diffuse.glsl"
#include "splitsum_direct_light.glsl"
#include "splitsum_directions.glsl"
#include "splitsum_ggx_fit.glsl"
#include "splitsum_irradiance.glsl"
#include "splitsum_levels.glsl"
#include "splitsum_sampling.glsl"
#include "splitsum_split_sum.glsl"
#include "splitsum_surface.glsl"

BETWEEN_STAGES(0) in vec3 world_normal;
BETWEEN_STAGES(1) in vec3 world_view;
BETWEEN_STAGES(2) in vec3 world_position;
layout(location = 0) out vec4 sum;

SAMPLER(0) uniform SPLITSUM_CUBE cube;
SAMPLER(2) uniform SPLITSUM_TABLE table;
SAMPLER(4) uniform SPLITSUM_TABLE_ARRAY tables;
BLOCK(3) uniform Arguments {
    vec4 list[4];
    vec3 order_2[9];
    vec3 order_3[16];
    vec3 order_4[25];
    float x;
    float y;
    int levels;
} given;

vec3 directions(vec3 d) {
    return splitsum_cube_from_left_handed(d) + splitsum_cube_from_right_handed(d) +
           splitsum_cube_from_three(d) + splitsum_turned_environment(d, given.x);
}

float levels() {
    return splitsum_level_linear(given.x, given.y) + splitsum_roughness_linear(given.x, given.y) +
           splitsum_level_filament(given.x, given.y) + splitsum_roughness_filament(given.x, given.y) +
           splitsum_level_of_list(given.x, given.list, given.levels);
}

vec3 irradiance(vec3 n) {
    return splitsum_irradiance_of_order_2(n, given.order_2) +
           splitsum_irradiance_of_order_3(n, given.order_3) +
           splitsum_irradiance_of_order_4(n, given.order_4) + splitsum_irradiance_over_pi(cube, n);
}

vec3 split_sum(vec3 f0) {
    vec2 at = splitsum_edge_coordinates(splitsum_table_coordinates(given.x, given.y), 64.0);
    vec2 ab = splitsum_read_table(table, at).xy + splitsum_ggx_fit(given.x, given.y);
    return splitsum_reflectance(f0, ab) + splitsum_directional_albedo_of_multiscatter(f0, ab) +
           splitsum_energy_compensation_of_multiscatter(f0, ab) +
           vec3(splitsum_multiple_scattering(ab.x, ab.y, given.x) +
                splitsum_multiple_scattering_of_lost(ab.x, ab.y, given.x));
}

vec3 surfaces(vec3 color) {
    vec3 reflectance = split_sum(splitsum_f0(color, given.x));
    vec3 albedo = splitsum_diffuse_albedo(color, given.x, reflectance);
    return splitsum_image_based_light(color, color, reflectance, albedo) +
           splitsum_cloth_reflectance(color, given.x) + splitsum_below_cloth(color, given.y) +
           splitsum_diffuse_reflectance(color, given.x) +
           splitsum_diffuse_reflectance_bounded(color, given.y);
}

vec3 direct_light(vec3 n, vec3 v, vec3 l) {
    float alpha2 = splitsum_alpha2_under_sun(given.x, splitsum_sun_radius);
    return splitsum_direct_specular(n, v, l, given.order_2[0], alpha2) +
           vec3(splitsum_direct_diffuse(n, l));
}

vec3 area_light(vec3 n, vec3 v) {
    vec3 corners[4];
    for (int i = 0; i < 4; ++i) corners[i] = given.order_2[i];
    vec2 at = splitsum_ltc_coordinates(given.x, given.y, 64.0) +
              splitsum_ltc_sphere_coordinates(given.x, given.y, 64.0);
    mat3 inverse_ltc = splitsum_ltc_inverse(splitsum_read_ltc(tables, at, 0.0));
    float share = splitsum_area_light(inverse_ltc, splitsum_light_frame(n, v), corners, false);
    return share * splitsum_ltc_reflectance(n, splitsum_read_ltc(tables, at, 1.0));
}

void main() {
    vec3 n = world_normal;
    vec3 v = world_view;
    sum.rgb = directions(v) + splitsum_specular_light(cube, v, levels()) + irradiance(n) +
              surfaces(v) + direct_light(n, v, world_position) + area_light(n, v);
    sum.a = 1.0;
}
