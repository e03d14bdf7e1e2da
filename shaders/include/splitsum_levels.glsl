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

// The level of a list that names the perceptual roughness of each of its `levels` levels, 16 at most:
// linear between neighbours, the first and the last level outside. Value i is list[i / 4][i % 4], which
// is how 16 floats lie in a uniform block. Values never fall.
float splitsum_level_of_list(float perceptual_roughness, vec4 list[4], int levels) {
    float r = clamp(perceptual_roughness, 0.0, 1.0);
    float level = 0.0;
    for (int i = 1; i < 16; ++i) {
        if (i >= levels) break;
        float below = list[(i - 1) / 4][(i - 1) % 4];
        float above = list[i / 4][i % 4];
        if (r > below) level = float(i - 1) + min((r - below) / max(above - below, 1e-20), 1.0);
    }
    return level;
}

#endif
