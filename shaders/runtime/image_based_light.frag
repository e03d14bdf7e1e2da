// A complete fragment shader over the baked assets: diffuse and specular light of an environment.
// Compiled as GLSL 4.50; for ES 3.00 replace the first two lines and give the inputs no locations.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "splitsum_levels.glsl"
#include "splitsum_split_sum.glsl"

layout(location = 0) in vec3 world_normal;
layout(location = 1) in vec3 world_view;  // from the surface towards the eye
layout(location = 0) out vec4 radiance;

layout(set = 0, binding = 0) uniform samplerCube specular_levels;
layout(set = 0, binding = 1) uniform samplerCube irradiance_over_pi;
layout(set = 0, binding = 2) uniform sampler2D split_sum_table;
layout(set = 0, binding = 3) uniform Material {
    vec3 base_color;
    float metalness;
    float perceptual_roughness;
    float last_level;
} material;

void main() {
    vec3 normal = normalize(world_normal);
    vec3 view = normalize(world_view);
    vec3 f0 = mix(vec3(0.04), material.base_color, material.metalness);
    vec3 albedo = material.base_color * (1.0 - material.metalness);

    vec2 split_sum = texture(split_sum_table,
                             splitsum_table_coordinates(dot(normal, view),
                                                        material.perceptual_roughness)).xy;
    vec3 reflected = splitsum_directional_albedo(f0, split_sum) *
                     splitsum_energy_compensation(f0, split_sum);
    float level = splitsum_level_linear(material.perceptual_roughness, material.last_level);
    vec3 specular = textureLod(specular_levels, reflect(-view, normal), level).rgb * reflected;
    vec3 diffuse = texture(irradiance_over_pi, normal).rgb * albedo * (vec3(1.0) - reflected);
    radiance = vec4(diffuse + specular, 1.0);
}
