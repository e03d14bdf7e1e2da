// Diffuse light from the harmonics that splitsum-irradiance and splitsum-bake write. GLSL 4.50 and
// ES 3.00.
//
// `coefficients` are the rows of harmonics.json in their order, as they are: index l (l + 1) + m. The
// result is E(n) / pi towards the unit normal n in the cube's axes (splitsum_directions.glsl): multiply
// by the albedo. A short series may fall below 0 opposite a strong light. The C++ twin is `evaluate` of
// lib/splitsum/filter/irradiance_harmonics.h; tests/shaders compares the two.
#ifndef SPLITSUM_IRRADIANCE_GLSL
#define SPLITSUM_IRRADIANCE_GLSL

// The share of one band, its coefficients from m = -l on (real harmonics without alternating signs:
// Sloan 2008, appendix A2).
vec3 splitsum_bands_0_1(vec3 n, vec3 c0, vec3 c1, vec3 c2, vec3 c3) {
    return 0.28209479177 * c0 + 0.48860251190 * (n.y * c1 + n.z * c2 + n.x * c3);
}

vec3 splitsum_band_2(vec3 n, vec3 c0, vec3 c1, vec3 c2, vec3 c3, vec3 c4) {
    return 1.09254843059 * (n.x * n.y * c0 + n.y * n.z * c1 + n.x * n.z * c3) +
           0.31539156525 * (3.0 * n.z * n.z - 1.0) * c2 +
           0.54627421530 * (n.x * n.x - n.y * n.y) * c4;
}

vec3 splitsum_band_3(vec3 n, vec3 c0, vec3 c1, vec3 c2, vec3 c3, vec3 c4, vec3 c5, vec3 c6) {
    vec3 n2 = n * n;
    return 0.59004358993 * (n.y * (3.0 * n2.x - n2.y) * c0 + n.x * (n2.x - 3.0 * n2.y) * c6) +
           n.z * (2.89061144264 * n.x * n.y * c1 + 1.44530572132 * (n2.x - n2.y) * c5) +
           0.45704579946 * (5.0 * n2.z - 1.0) * (n.y * c2 + n.x * c4) +
           0.37317633259 * n.z * (5.0 * n2.z - 3.0) * c3;
}

vec3 splitsum_band_4(vec3 n, vec3 c0, vec3 c1, vec3 c2, vec3 c3, vec3 c4, vec3 c5, vec3 c6, vec3 c7,
                     vec3 c8) {
    vec3 n2 = n * n;
    return 2.50334294180 * n.x * n.y * (n2.x - n2.y) * c0 +
           1.77013076978 * n.z * (n.y * (3.0 * n2.x - n2.y) * c1 + n.x * (n2.x - 3.0 * n2.y) * c7) +
           (7.0 * n2.z - 1.0) * (0.94617469576 * n.x * n.y * c2 + 0.47308734788 * (n2.x - n2.y) * c6) +
           0.66904654356 * n.z * (7.0 * n2.z - 3.0) * (n.y * c3 + n.x * c5) +
           0.10578554692 * (n2.z * (35.0 * n2.z - 30.0) + 3.0) * c4 +
           0.62583573545 * (n2.x * (n2.x - 3.0 * n2.y) - n2.y * (3.0 * n2.x - n2.y)) * c8;
}

vec3 splitsum_irradiance_of_order_2(vec3 n, vec3 coefficients[9]) {
    return splitsum_bands_0_1(n, coefficients[0], coefficients[1], coefficients[2], coefficients[3]) +
           splitsum_band_2(n, coefficients[4], coefficients[5], coefficients[6], coefficients[7],
                           coefficients[8]);
}

vec3 splitsum_irradiance_of_order_3(vec3 n, vec3 coefficients[16]) {
    return splitsum_bands_0_1(n, coefficients[0], coefficients[1], coefficients[2], coefficients[3]) +
           splitsum_band_2(n, coefficients[4], coefficients[5], coefficients[6], coefficients[7],
                           coefficients[8]) +
           splitsum_band_3(n, coefficients[9], coefficients[10], coefficients[11], coefficients[12],
                           coefficients[13], coefficients[14], coefficients[15]);
}

vec3 splitsum_irradiance_of_order_4(vec3 n, vec3 coefficients[25]) {
    return splitsum_bands_0_1(n, coefficients[0], coefficients[1], coefficients[2], coefficients[3]) +
           splitsum_band_2(n, coefficients[4], coefficients[5], coefficients[6], coefficients[7],
                           coefficients[8]) +
           splitsum_band_3(n, coefficients[9], coefficients[10], coefficients[11], coefficients[12],
                           coefficients[13], coefficients[14], coefficients[15]) +
           splitsum_band_4(n, coefficients[16], coefficients[17], coefficients[18], coefficients[19],
                           coefficients[20], coefficients[21], coefficients[22], coefficients[23],
                           coefficients[24]);
}

#endif
