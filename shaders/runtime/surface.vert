// The vertex shader of all fragment shaders here: a mesh in world axes.
#include "interface.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;

BLOCK(6) uniform View {
    mat4 clip_from_world;
    vec4 eye;  // world position; w is not used
} view_block;

BETWEEN_STAGES(0) out vec3 world_normal;
BETWEEN_STAGES(1) out vec3 world_view;  // from the surface towards the eye
BETWEEN_STAGES(2) out vec3 world_position;

void main() {
    world_normal = normal;
    world_view = view_block.eye.xyz - position;
    world_position = position;
    gl_Position = view_block.clip_from_world * vec4(position, 1.0);
}
