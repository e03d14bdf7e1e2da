#pragma once

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/image/image.h"
#include "splitsum/math/vec.h"
#include "splitsum/measure/error_figures.h"
#include "splitsum/preview/camera.h"
#include "splitsum/preview/scene.h"
#include "splitsum/sphere/environment.h"

namespace splitsum {

/// What assets without any error would show.
struct SplitExact {
    Image radiance;  ///< scene-linear; 0 where no sphere is
    ErrorFigures
        checked;  ///< of `radiance` against fp64 integration over every texel of the panorama
};

/// The split sum with nothing stored: at every pixel prefiltered light towards the mirror direction
/// at the sphere's own roughness, the exact split sum of the view, and irradiance. Light is
/// filtered by `spectral` with an accuracy of 1e-5 (filter/methods.h), at the directions themselves
/// instead of texels. How exact that is, is measured: `checks` pixels of each sphere, evenly
/// spread, are compared with `reference`.
///
/// Prefiltered light of a perfect mirror is the radiance of the panorama's texel in that direction,
/// the limit of narrow lobes. The level 0 of a chain holds means over the cube's texels instead,
/// and an engine reads between these: what a mirror loses by that is an error of the baked data.
///
/// Cost: 0.5 s for a 1024 x 512 panorama on two cores where perceptual roughness is above 0.1 or 0,
/// some seconds below, and 1 to 2 ms a check on one core. Progress: the stages "filtering" and
/// "measuring". Fails only when cancelled.
Result<SplitExact> split_exact(const Scene& scene, const Camera& camera,
                               const Environment& environment, const Mat3d& panorama_from_cube,
                               int checks, Progress& progress);

}  // namespace splitsum
