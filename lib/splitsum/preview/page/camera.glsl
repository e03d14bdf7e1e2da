// What is seen through a point of the picture. The twin of preview/camera.h; camera.js places the camera.
uniform vec2 picture_size;       // in pixels
uniform float tan_half_height;   // of half the vertical field of view
uniform vec3 camera_position;    // in view axes, as the spheres are
uniform mat3 cube_from_view;

// Two texels a sphere, in a row: centre and radius; base colour and metalness. A third holds perceptual
// roughness in red.
uniform highp sampler2D spheres;
uniform int sphere_count;

struct Seen {
    int sphere;   // -1: the background
    vec3 normal;  // in the cube's axes, as the next
    vec3 view;    // from the surface to the camera
};

// `place` in pixels from the lower left corner of the picture; in view axes.
vec3 ray_through(vec2 place) {
    vec2 from_middle = (place - 0.5 * picture_size) * (2.0 * tan_half_height / picture_size.y);
    return normalize(vec3(from_middle, 1.0));
}

Seen first_surface(vec3 ray) {
    Seen seen = Seen(-1, vec3(0.0), cube_from_view * -ray);
    float nearest = 1e30;
    for (int i = 0; i < sphere_count; ++i) {
        vec4 sphere = texelFetch(spheres, ivec2(0, i), 0);
        vec3 offset = sphere.xyz - camera_position;
        float along = dot(offset, ray);
        vec3 closest = offset - along * ray;  // from the ray to the centre
        float depth2 = sphere.w * sphere.w - dot(closest, closest);
        if (depth2 < 0.0) continue;
        float depth = sqrt(depth2);
        float distance_along = along - depth;
        if (distance_along <= 0.0 || distance_along >= nearest) continue;
        nearest = distance_along;
        seen.sphere = i;
        // The surface less the centre: differences of large distances have cancelled in `closest`.
        seen.normal = normalize(cube_from_view * (-depth * ray - closest));
    }
    return seen;
}
