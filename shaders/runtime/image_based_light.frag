// Diffuse and specular light of an environment from the baked cubemaps and the table `ggx`. World axes
// are those of a viewer that looks down -z; other engines take their own line of
// splitsum_directions.glsl.
#include "interface.glsl"
#include "splitsum_directions.glsl"
#include "splitsum_levels.glsl"
#include "splitsum_sampling.glsl"
#include "splitsum_split_sum.glsl"
#include "splitsum_surface.glsl"

BETWEEN_STAGES(0) in vec3 world_normal;
BETWEEN_STAGES(1) in vec3 world_view;
BETWEEN_STAGES(2) in vec3 world_position;
layout(location = 0) out vec4 radiance;

SAMPLER(0) uniform SPLITSUM_CUBE specular_levels;
SAMPLER(1) uniform SPLITSUM_CUBE irradiance;
SAMPLER(2) uniform SPLITSUM_TABLE split_sum_table;
BLOCK(3) uniform Material {
    vec3 base_color;
    float metalness;
    float perceptual_roughness;
    float last_level;         // number of levels less one
    float radians_about_y;    // how far the environment is turned
} material;

vec3 cube_direction(vec3 world_direction) {
    return splitsum_turned_environment(splitsum_cube_from_right_handed(world_direction),
                                       material.radians_about_y);
}

void main() {
    vec3 normal = normalize(world_normal);
    vec3 view = normalize(world_view);
    vec3 reflection = cube_direction(reflect(-view, normal));
    float level = splitsum_level_linear(material.perceptual_roughness, material.last_level);

    vec3 f0 = splitsum_f0(material.base_color, material.metalness);
    vec2 coordinates = splitsum_table_coordinates(dot(normal, view), material.perceptual_roughness);
    vec3 reflectance = splitsum_reflectance(f0, splitsum_read_table(split_sum_table, coordinates).rg);
    vec3 albedo = splitsum_diffuse_albedo(material.base_color, material.metalness, reflectance);

    radiance.rgb = splitsum_image_based_light(
        splitsum_specular_light(specular_levels, reflection, level),
        splitsum_irradiance_over_pi(irradiance, cube_direction(normal)), reflectance, albedo);
    radiance.a = 1.0;
}
