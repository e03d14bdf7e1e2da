// Flat lights with four corners, by the tables `ltc-ggx` and `ltc-disney`. GLSL 4.50 and ES 3.00.
//
// Two layers of `size` by `size` texels at the edges (--layout edge, the default of these tables),
// right: perceptual roughness, down: sqrt(1 - n·v). Sample with a linear filter and clamp to the edge.
// The C++ twins are lib/splitsum/table/ltc_lookup.h and lib/splitsum/shading/area_light.h;
// tests/shaders compares them.
#ifndef SPLITSUM_AREA_LIGHT_GLSL
#define SPLITSUM_AREA_LIGHT_GLSL

// Where texels at the edges hold coordinates in [0, 1].
vec2 splitsum_ltc_texels(vec2 coordinates, float size) {
    float half_texel = 0.5 / size;
    float covered = 1.0 - 2.0 * half_texel;
    return coordinates * covered + vec2(half_texel);
}

// Where both layers are sampled for a surface.
vec2 splitsum_ltc_coordinates(float n_dot_v, float perceptual_roughness, float size) {
    return splitsum_ltc_texels(vec2(clamp(perceptual_roughness, 0.0, 1.0),
                                    sqrt(1.0 - clamp(n_dot_v, 0.0, 1.0))), size);
}

// Where layer 1 is sampled, alpha alone, for the share of a sphere's form factor that the horizon
// leaves. The sphere's centre lies at this cosine from the normal; `form_factor` is that of the sphere
// facing it.
vec2 splitsum_ltc_sphere_coordinates(float cos_to_centre, float form_factor, float size) {
    return splitsum_ltc_texels(vec2(clamp(0.5 * cos_to_centre + 0.5, 0.0, 1.0),
                                    clamp(form_factor, 0.0, 1.0)), size);
}

// The matrix that carries directions to the space where the lobe is a clamped cosine, from layer 0: in
// the frame of normal (z) and the viewer's side of the surface (x).
mat3 splitsum_ltc_inverse(vec4 layer0) {
    return mat3(vec3(layer0.x, 0.0, layer0.y), vec3(0.0, 1.0, 0.0),
                vec3(layer0.z, 0.0, layer0.w));
}

// What a polygon's form factor in that space is multiplied with, from layer 1: albedo for F = 1,
// within 1 %, and the same weighted with (1 - v·h)^5 (Hill 2016, "LTC Fresnel Approximation").
vec3 splitsum_ltc_reflectance(vec3 f0, vec4 layer1) {
    return f0 * layer1.x + (vec3(1.0) - f0) * layer1.y;
}

// Carries world directions into the frame of the matrix: z the normal, x the viewer's side. Unit
// vectors. Where the viewer looks along the normal any side will do.
mat3 splitsum_light_frame(vec3 normal, vec3 view) {
    vec3 side = view - dot(normal, view) * normal;
    if (dot(side, side) < 1e-12) {
        vec3 other = abs(normal.z) < 0.5 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
        side = cross(normal, other);
    }
    vec3 x = normalize(side);
    return transpose(mat3(x, cross(normal, x), normal));
}

// What an edge adds to a form factor: its angle times the z of the unit normal of its plane, over
// 2 pi (Lambert 1760). Ends at any distance.
float splitsum_edge_form_factor(vec3 from, vec3 to) {
    vec3 start = normalize(from);
    vec3 end = normalize(to);
    vec3 normal = cross(start, end);
    float sine = length(normal);
    if (sine <= 0.0) return 0.0;
    return atan(sine, dot(start, end)) * normal.z / sine * 0.15915494309;
}

// The share of a clamped cosine about +z that a convex quadrilateral covers, in [0, 1]. What lies below
// the horizon is cut off edge by edge; the polygon leaves and enters the upper half once at most,
// and an edge along the horizon joins the two places.
float splitsum_quad_form_factor(vec3 corners[4]) {
    float sum = 0.0;
    vec3 leaves = vec3(0.0);
    vec3 enters = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        vec3 from = corners[i];
        vec3 to = corners[(i + 1) % 4];
        bool starts_above = from.z > 0.0;
        bool ends_above = to.z > 0.0;
        if (starts_above != ends_above) {
            vec3 crossing = from + from.z / (from.z - to.z) * (to - from);
            crossing.z = 0.0;
            if (starts_above) {
                to = crossing;
                leaves = crossing;
            } else {
                from = crossing;
                enters = crossing;
            }
        }
        if (starts_above || ends_above) sum += splitsum_edge_form_factor(from, to);
    }
    if (dot(leaves, leaves) > 0.0 && dot(enters, enters) > 0.0)
        sum += splitsum_edge_form_factor(leaves, enters);
    return abs(sum);
}

// Whether a light of one side shines here: its corners as seen from the shaded point.
bool splitsum_shows_its_lit_side(vec3 corners[4]) {
    return dot(cross(corners[1] - corners[0], corners[3] - corners[0]), corners[0]) < 0.0;
}

// What a lobe gathers from a convex flat light, as a share of its radiance, in [0, 1]. `corners`: in
// order, world axes, minus the shaded point; a triangle has its last corner twice. The lit side is the
// one that cross(corners[1] - corners[0], corners[3] - corners[0]) points to. Times
// splitsum_ltc_reflectance and the light's radiance it is the radiance towards the viewer; with
// mat3(1.0) for `inverse_ltc`, times an albedo, the diffuse one.
float splitsum_area_light(mat3 inverse_ltc, mat3 frame, vec3 corners[4], bool two_sided) {
    if (!two_sided && !splitsum_shows_its_lit_side(corners)) return 0.0;
    mat3 carry = inverse_ltc * frame;
    vec3 carried[4];
    for (int i = 0; i < 4; ++i) carried[i] = carry * corners[i];
    return splitsum_quad_form_factor(carried);
}

#endif
