#pragma once

#include <algorithm>
#include <numbers>

#include "splitsum/image/table.h"
#include "splitsum/table/split_sum.h"

namespace splitsum {

/// What a renderer reads from a split-sum table of two channels in the default arrangement: bilinear
/// between texel centres, clamped at the edges. `n_dot_v` and `perceptual_roughness` are clamped to [0, 1]. This file is the twin
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

/// What the surface reflects of uniform light with all bounces, in [0, 1]: what prefiltered light is
/// multiplied with.
inline double reflectance(const SplitSum& split_sum, double f0) {
    return directional_albedo(split_sum, f0) * energy_compensation(split_sum, f0);
}

/// What a table `ggx-multiscatter` holds, (b, a + b), as the split sum it was made of.
inline SplitSum split_sum_of_multiscatter(double bias, double albedo) {
    return {albedo - bias, bias};
}

/// What light between the microfacets adds to the BRDF of a perfect reflector, from a table `energy`
/// read for the view and for the light: (1 - E(v)) (1 - E(l)) / (pi (1 - E_avg)) (Kulla & Conty 2017).
/// What is lost on average counts as 1e-6 at least.
inline double multiple_scattering(double energy_view, double energy_light, double average_energy) {
    return (1 - energy_view) * (1 - energy_light) * std::numbers::inv_pi /
           std::max(1 - average_energy, 1e-6);
}

/// The same from a table `energy-lost`. What is lost on average counts as 1e-20 at least.
inline double multiple_scattering_of_lost(double lost_view, double lost_light,
                                          double average_lost) {
    return lost_view * lost_light * std::numbers::inv_pi / std::max(average_lost, 1e-20);
}

}  // namespace splitsum
