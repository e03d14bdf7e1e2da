// Cloth over a diffuse base under an environment, from the baked cubemaps and a table `charlie`. Its lobe
// is read from the specular cubemap at its roughness, as Filament does: its peak is far from the mirror
// direction, so this is an approximation, the albedo is not.
#include "interface.glsl"
#include "splitsum_cloth.glsl"
#include "splitsum_directions.glsl"
#include "splitsum_levels.glsl"
#include "splitsum_sampling.glsl"
#include "splitsum_split_sum.glsl"

BETWEEN_STAGES(0) in vec3 world_normal;
BETWEEN_STAGES(1) in vec3 world_view;
BETWEEN_STAGES(2) in vec3 world_position;
layout(location = 0) out vec4 radiance;

SAMPLER(0) uniform SPLITSUM_CUBE specular_levels;
SAMPLER(1) uniform SPLITSUM_CUBE irradiance;
SAMPLER(2) uniform SPLITSUM_TABLE cloth_table;
BLOCK(3) uniform Material {
    vec3 base_color;
    float perceptual_roughness;
    vec3 sheen_color;
    float last_level;
} material;

void main() {
    vec3 normal = normalize(world_normal);
    vec3 view = normalize(world_view);
    vec3 reflection = splitsum_cube_from_right_handed(reflect(-view, normal));
    float level = splitsum_level_filament(material.perceptual_roughness, material.last_level);

    vec2 coordinates = splitsum_table_coordinates(dot(normal, view), material.perceptual_roughness);
    float cloth_albedo = splitsum_read_table(cloth_table, coordinates).r;
    vec3 sheen = splitsum_cloth_reflectance(material.sheen_color, cloth_albedo);
    vec3 diffuse = splitsum_irradiance_over_pi(irradiance, splitsum_cube_from_right_handed(normal));

    radiance.rgb = splitsum_specular_light(specular_levels, reflection, level) * sheen +
                   diffuse * material.base_color *
                       splitsum_below_cloth(material.sheen_color, cloth_albedo);
    radiance.a = 1.0;
}
