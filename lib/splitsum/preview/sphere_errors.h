#pragma once

#include <vector>

#include "splitsum/image/image.h"
#include "splitsum/measure/error_figures.h"
#include "splitsum/preview/truth_picture.h"

namespace splitsum {

/// A difference from a noisy truth, with the truth's noise taken out of it.
struct NoisyFigures {
    /// sqrt(sum (x - t)² - v) / sqrt(sum t² - v) over pixels and channels, with v the squared
    /// standard error of t: what ErrorFigures::rel_rms would be without noise; 0 where noise
    /// explains all.
    double rel_rms = 0;
    double bias = 0;   ///< sum x / sum t - 1
    double noise = 0;  ///< sqrt(sum v / sum t²): of the truth at the same pixels
    int pixels = 0;    ///< compared; those without truth are left out
};

/// Why a sphere under baked light does not look as it should, over all of its pixels.
struct SphereErrors {
    /// (a) The baked data alone, texels, levels, formats and table: the baked picture against the
    /// exact split sum.
    ErrorFigures baked_data;
    /// (b) The split-sum approximation alone, which no bake can help: the exact split sum against
    /// the truth.
    NoisyFigures approximation;
    /// Both together: the baked picture against the truth.
    NoisyFigures together;
};

/// For each of `spheres` spheres: `baked` is the picture of the scene, `exact` the radiance of
/// split_exact and `truth` of truth_picture for the same scene and camera.
std::vector<SphereErrors> sphere_errors(const Image& baked, const Image& exact,
                                        const TruthPicture& truth, int spheres);

}  // namespace splitsum
