// The same light without a table and without an irradiance cubemap: the closed form of the split sum
// and nine harmonics, and levels whose roughness is a list.
#include "interface.glsl"
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
layout(location = 0) out vec4 radiance;

SAMPLER(0) uniform SPLITSUM_CUBE specular_levels;
BLOCK(3) uniform Material {
    vec3 base_color;
    float metalness;
    float perceptual_roughness;
    int levels;
    vec4 roughness_of_level[4];  // 16 values in a row
    vec3 harmonics[9];           // the rows of harmonics.json, each padded to four floats
} material;

void main() {
    vec3 normal = normalize(world_normal);
    vec3 view = normalize(world_view);
    vec3 reflection = splitsum_cube_from_right_handed(reflect(-view, normal));
    float level = splitsum_level_of_list(material.perceptual_roughness, material.roughness_of_level,
                                         material.levels);

    vec3 f0 = splitsum_f0(material.base_color, material.metalness);
    vec2 split_sum = splitsum_ggx_fit(dot(normal, view), material.perceptual_roughness);
    vec3 reflectance = splitsum_reflectance(f0, split_sum);
    vec3 albedo = splitsum_diffuse_albedo(material.base_color, material.metalness, reflectance);
    vec3 diffuse = splitsum_irradiance_of_order_2(splitsum_cube_from_right_handed(normal),
                                                  material.harmonics);

    radiance.rgb = splitsum_image_based_light(
        splitsum_specular_light(specular_levels, reflection, level), max(diffuse, vec3(0.0)),
        reflectance, albedo);
    radiance.a = 1.0;
}
