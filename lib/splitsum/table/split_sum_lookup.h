#pragma once

#include "splitsum/image/table.h"
#include "splitsum/table/split_sum.h"

namespace splitsum {

/// What a renderer reads from a split-sum table of two channels in the default arrangement: bilinear between texel centres, clamped at the
/// edges. `n_dot_v` and `perceptual_roughness` are clamped to [0, 1]. This file is the twin
/// of shaders/include/splitsum_split_sum.glsl; the sampler is the graphics interface's.
SplitSum look_up(const Table& table, double n_dot_v, double perceptual_roughness);

/// The directional albedo F0 a + b: the share of uniform light that the surface sends to the viewer
/// in one bounce. `f0` is the reflectance at normal incidence, in [0, 1].
inline double directional_albedo(const SplitSum& split_sum, double f0) {
    return f0 * split_sum.a + split_sum.b;
}

/// What single-bounce light is multiplied with so that no energy is lost between the microfacets:
/// 1 + f0 (1 / (a + b) - 1); a surface with f0 = 1 then returns all of a white furnace (Turquin
/// 2019, "Practical multiple scattering compensation for microfacet models"). a + b > 0.
inline double energy_compensation(const SplitSum& split_sum, double f0) {
    return 1 + f0 * (1 / (split_sum.a + split_sum.b) - 1);
}

}  // namespace splitsum
