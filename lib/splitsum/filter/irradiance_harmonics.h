#pragma once

#include <vector>

#include "splitsum/filter/filter_source.h"
#include "splitsum/math/vec.h"
#include "splitsum/sphere/environment.h"

namespace splitsum {

/// Diffuse light as coefficients of the real harmonics of math/harmonics.h in the cube's axes:
/// E(n) / pi = sum over l, m of coefficients[l (l + 1) + m] * Y_lm(n).
struct IrradianceHarmonics {
    int order = 2;
    std::vector<Vec3d> coefficients;
    /// How much the bands were damped against ringing: band l is divided by
    /// 1 + window_lambda * l² (l + 1)² (Sloan 2008, "Stupid Spherical Harmonics (SH) Tricks", the
    /// least-squares Laplacian window); 0 without windowing.
    double window_lambda = 0;
    /// The smallest value of any channel over the sphere, as a share of the channel's mean: a sun
    /// can push a short series below zero.
    double lowest = 0;
};

/// The harmonics of the radiance, band l multiplied by the factor A_l / pi of the clamped cosine
/// (Ramamoorthi & Hanrahan 2001, eq. 19). With `windowed`, bands are damped by the smallest
/// window_lambda that leaves no channel negative anywhere.
IrradianceHarmonics irradiance_harmonics(const FilterSource& source, int order, bool windowed,
                                         const Mat3d& panorama_from_cube);

/// E / pi towards a unit normal: what a renderer evaluates.
Vec3d evaluate(const IrradianceHarmonics& harmonics, const Vec3d& normal);

}  // namespace splitsum
