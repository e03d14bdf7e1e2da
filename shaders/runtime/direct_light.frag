// A sun and a flat light with four corners, to be added to the light of the environment.
#include "interface.glsl"
#include "splitsum_area_light.glsl"
#include "splitsum_direct_light.glsl"
#include "splitsum_sampling.glsl"
#include "splitsum_split_sum.glsl"
#include "splitsum_surface.glsl"

BETWEEN_STAGES(0) in vec3 world_normal;
BETWEEN_STAGES(1) in vec3 world_view;
BETWEEN_STAGES(2) in vec3 world_position;
layout(location = 0) out vec4 radiance;

SAMPLER(2) uniform SPLITSUM_TABLE split_sum_table;
SAMPLER(4) uniform SPLITSUM_TABLE_ARRAY ltc_tables;
BLOCK(3) uniform Material {
    vec3 base_color;
    float metalness;
    float perceptual_roughness;
    float ltc_size;  // texels along an edge of ltc_tables
} material;
BLOCK(5) uniform Lights {
    vec4 towards_sun;      // w: angular radius in radians
    vec4 sun_illuminance;  // across its direction; w is not used
    vec4 corners[4];       // of the flat light, world positions; w is not used
    vec4 light_radiance;   // w: 1 for a light of two sides, 0 for one
} lights;

vec3 sun(vec3 normal, vec3 view, vec3 f0, vec3 compensation, vec3 albedo) {
    float alpha2 = splitsum_alpha2_under_sun(material.perceptual_roughness, lights.towards_sun.w);
    vec3 towards = lights.towards_sun.xyz;
    vec3 specular = splitsum_direct_specular(normal, view, towards, f0, alpha2) * compensation;
    return lights.sun_illuminance.rgb *
           (specular + albedo * splitsum_direct_diffuse(normal, towards));
}

vec3 flat_light(vec3 normal, vec3 view, vec3 f0, vec3 compensation, vec3 albedo) {
    vec3 corners[4];
    for (int i = 0; i < 4; ++i) corners[i] = lights.corners[i].xyz - world_position;
    bool two_sided = lights.light_radiance.w > 0.5;
    mat3 frame = splitsum_light_frame(normal, view);
    vec2 at = splitsum_ltc_coordinates(dot(normal, view), material.perceptual_roughness,
                                       material.ltc_size);
    mat3 inverse_ltc = splitsum_ltc_inverse(splitsum_read_ltc(ltc_tables, at, 0.0));
    vec3 reflected = splitsum_ltc_reflectance(f0, splitsum_read_ltc(ltc_tables, at, 1.0));
    float diffuse = splitsum_area_light(mat3(1.0), frame, corners, two_sided);
    float specular = splitsum_area_light(inverse_ltc, frame, corners, two_sided);
    return lights.light_radiance.rgb * (specular * reflected * compensation + diffuse * albedo);
}

void main() {
    vec3 normal = normalize(world_normal);
    vec3 view = normalize(world_view);
    vec3 f0 = splitsum_f0(material.base_color, material.metalness);
    vec2 coordinates = splitsum_table_coordinates(dot(normal, view), material.perceptual_roughness);
    vec2 split_sum = splitsum_read_table(split_sum_table, coordinates).rg;
    vec3 compensation = splitsum_energy_compensation(f0, split_sum);
    vec3 albedo = splitsum_diffuse_albedo(material.base_color, material.metalness,
                                          splitsum_reflectance(f0, split_sum));
    radiance.rgb = sun(normal, view, f0, compensation, albedo) +
                   flat_light(normal, view, f0, compensation, albedo);
    radiance.a = 1.0;
}
