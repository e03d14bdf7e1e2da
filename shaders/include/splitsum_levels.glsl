// Which level of the specular cubemap holds a roughness, and back. GLSL 4.50 and ES 3.00.
//
// `last_level` is the number of levels less one; it may be 0, and the only level then is the mirror.
// The C++ twin is lib/splitsum/plan/roughness_curve.h; tests/shaders compares the two. Read
// between levels with textureLod and a linear mip filter.
#ifndef SPLITSUM_LEVELS_GLSL
#define SPLITSUM_LEVELS_GLSL

// The curve `linear`: level = r last_level.
float splitsum_level_linear(float perceptual_roughness, float last_level) {
    return clamp(perceptual_roughness, 0.0, 1.0) * last_level;
}

// Perceptual roughness of a level of the curve `linear`.
float splitsum_roughness_linear(float level, float last_level) {
    return clamp(level / max(last_level, 1.0), 0.0, 1.0);
}

// The curve `filament`: level = r (2 - r) last_level. More levels for smooth surfaces.
float splitsum_level_filament(float perceptual_roughness, float last_level) {
    float r = clamp(perceptual_roughness, 0.0, 1.0);
    return r * (2.0 - r) * last_level;
}

// Perceptual roughness of a level of the curve `filament`: 1 - sqrt(1 - lod), written as
// lod / (1 + sqrt(1 - lod)) because the difference cancels at small lod.
float splitsum_roughness_filament(float level, float last_level) {
    float lod = clamp(level / max(last_level, 1.0), 0.0, 1.0);
    return lod / (1.0 + sqrt(1.0 - lod));
}

#endif
