// Spheres under baked light, shaded by the library of shaders/include as an engine would; one level, the
// irradiance or the table alone; the truth beside them, and the difference.
#include "splitsum_levels.glsl"
#include "splitsum_sampling.glsl"
#include "splitsum_split_sum.glsl"
#include "splitsum_surface.glsl"
#include "camera.glsl"
#include "view.glsl"

out vec4 pixel;

uniform SPLITSUM_CUBE specular_levels;
uniform SPLITSUM_CUBE irradiance;
uniform SPLITSUM_TABLE split_sum_table;
uniform SPLITSUM_TABLE truth;

const int CURVE_LINEAR = 0;
const int CURVE_FILAMENT = 1;
uniform int curve;             // any other is the list
uniform float last_level;      // number of levels less one
uniform vec4 roughness_list[4];

// What is on a sphere, and what is behind them. From 0 on: that level of the specular chain, which may
// lie between two.
const float SHADED = -1.0;
const float IRRADIANCE = -2.0;
const float BLACK = -3.0;
const float TABLE = -4.0;
uniform float on_spheres;
uniform float behind;

uniform float exposure;        // a factor
uniform bool smooth_edges;     // else every pixel is what is seen at its centre
uniform float truth_from;      // from this pixel column on the truth is shown

uniform bool shows_difference;  // of baked light from the truth
uniform float least_luminance;
uniform float full_difference;
uniform vec3 too_bright;
uniform vec3 too_dark;
uniform vec3 difference_background;

float level_of(float perceptual_roughness) {
    if (curve == CURVE_LINEAR) return splitsum_level_linear(perceptual_roughness, last_level);
    if (curve == CURVE_FILAMENT) return splitsum_level_filament(perceptual_roughness, last_level);
    return splitsum_level_of_list(perceptual_roughness, roughness_list, int(last_level) + 1);
}

vec3 shaded(Seen seen, vec3 mirrored) {
    vec4 colour = texelFetch(spheres, ivec2(1, seen.sphere), 0);
    float perceptual_roughness = texelFetch(spheres, ivec2(2, seen.sphere), 0).r;
    vec3 f0 = splitsum_f0(colour.rgb, colour.a);
    vec2 coordinates = splitsum_table_coordinates(dot(seen.normal, seen.view), perceptual_roughness);
    vec3 reflectance = splitsum_reflectance(f0, splitsum_read_table(split_sum_table, coordinates).rg);
    vec3 albedo = splitsum_diffuse_albedo(colour.rgb, colour.a, reflectance);
    return splitsum_image_based_light(
        splitsum_specular_light(specular_levels, mirrored, level_of(perceptual_roughness)),
        splitsum_irradiance_over_pi(irradiance, seen.normal), reflectance, albedo);
}

// Light that is shown as it is stored.
vec3 stored_light(float which, vec3 normal, vec3 mirrored) {
    if (which == BLACK) return vec3(0.0);
    if (which == IRRADIANCE) return splitsum_irradiance_over_pi(irradiance, normal);
    return splitsum_specular_light(specular_levels, mirrored, which);
}

// Its rows count from the top.
vec3 truth_at(vec2 place) {
    vec2 from_top = vec2(place.x, picture_size.y - place.y) / picture_size;
    return textureLod(truth, from_top, 0.0).rgb;
}

vec3 light_on_sphere(vec2 place, Seen seen) {
    if (place.x >= truth_from) return truth_at(place);
    vec3 mirrored = reflect(-seen.view, seen.normal);
    return on_spheres == SHADED ? shaded(seen, mirrored)
                                : stored_light(on_spheres, seen.normal, mirrored);
}

float luminance(vec3 rgb) {
    return dot(rgb, vec3(0.2126, 0.7152, 0.0722));
}

// The twin of preview/difference.h.
vec3 difference_at(vec2 place, Seen seen) {
    if (seen.sphere < 0) return difference_background;
    float baked = luminance(shaded(seen, reflect(-seen.view, seen.normal)));
    float exact = luminance(truth_at(place));
    float relative = (baked - exact) / max(max(exact, least_luminance), 1e-20);
    vec3 end = relative > 0.0 ? too_bright : too_dark;
    return mix(vec3(1.0), end, min(abs(relative) / full_difference, 1.0));
}

// The table as a square in the middle: n·v to the right, perceptual roughness upwards.
vec3 table_at(vec2 place) {
    float side = min(picture_size.x, picture_size.y);
    vec2 coordinates = (place - 0.5 * (picture_size - side)) / side;
    if (any(notEqual(coordinates, clamp(coordinates, 0.0, 1.0)))) return vec3(0.0);
    return srgb(vec3(splitsum_read_table(split_sum_table, coordinates).rg, 0.0));
}

vec3 colour_at(vec2 place) {
    if (on_spheres == TABLE) return table_at(place);
    vec3 ray = ray_through(place);
    Seen seen = first_surface(ray);
    if (shows_difference) return difference_at(place, seen);
    vec3 ahead = cube_from_view * ray;
    return shown(exposure * (seen.sphere < 0 ? stored_light(behind, ahead, ahead)
                                             : light_on_sphere(place, seen)));
}

// Whether not all corners of a pixel see the same sphere.
bool is_edge(vec2 corner) {
    int sphere = first_surface(ray_through(corner)).sphere;
    for (int i = 1; i < 4; ++i)
        if (first_surface(ray_through(corner + vec2(i & 1, i >> 1))).sphere != sphere) return true;
    return false;
}

void main() {
    vec2 corner = floor(gl_FragCoord.xy);
    int samples = smooth_edges && on_spheres != TABLE && is_edge(corner) ? 3 : 1;  // along an axis
    vec3 sum = vec3(0.0);
    for (int y = 0; y < samples; ++y)
        for (int x = 0; x < samples; ++x)
            sum += colour_at(corner + (vec2(x, y) + 0.5) / float(samples));
    pixel = vec4(sum / float(samples * samples), 1.0);
}
