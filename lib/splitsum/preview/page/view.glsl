// From scene-linear Rec.709 to what an sRGB screen is sent. The twin of preview/tone_curve.h and
// preview/view_lut.h.
const int VIEW_SRGB = 0;
const int VIEW_FILMIC = 1;
const int VIEW_LUT = 2;

uniform int view;
uniform highp sampler3D view_lut;
uniform float lut_size;        // texels along an axis
uniform float lut_steepness;
uniform float lut_brightest;

vec3 srgb(vec3 linear) {
    vec3 x = clamp(linear, 0.0, 1.0);
    return mix(1.055 * pow(x, vec3(1.0 / 2.4)) - 0.055, 12.92 * x, lessThanEqual(x, vec3(0.0031308)));
}

vec3 filmic(vec3 linear) {
    // Where the curve is 1 to the last bit, before its square leaves the range of floats.
    vec3 x = clamp(linear, 0.0, 1e6);
    return srgb(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14));
}

vec3 from_lut(vec3 linear) {
    vec3 x = clamp(linear, 0.0, lut_brightest);
    vec3 share = log2(1.0 + lut_steepness * x) / log2(1.0 + lut_steepness * lut_brightest);
    return textureLod(view_lut, (share * (lut_size - 1.0) + 0.5) / lut_size, 0.0).rgb;
}

vec3 shown(vec3 linear) {
    if (view == VIEW_LUT) return from_lut(linear);
    return view == VIEW_FILMIC ? filmic(linear) : srgb(linear);
}
