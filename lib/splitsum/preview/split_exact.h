#pragma once

#include <vector>

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/math/vec.h"
#include "splitsum/preview/camera.h"
#include "splitsum/preview/scene.h"
#include "splitsum/sphere/environment.h"

namespace splitsum {

/// What perfect assets would show at a pixel.
struct ExactPixel {
    int index;   ///< y * width + x
    int sphere;  ///< index into the scene
    Vec3 radiance;
};

/// The split sum with nothing stored: exact prefiltered light towards the mirror direction at the
/// sphere's own roughness (filter/reference_probes.h), the exact split sum of the view and exact
/// irradiance, at `pixels_per_sphere` pixels of each sphere, evenly spread over those in which it is
/// seen, or all where there are no more. Sphere by sphere, in the order of pixels.
///
/// Prefiltered light of a perfect mirror is the radiance of the panorama's texel in that direction,
/// the limit of narrow lobes. The level 0 of a chain holds means over the cube's texels instead, and
/// an engine reads between these: what a mirror loses by that counts as an error of the baked data.
///
/// Cost: about 1 ms a pixel of metals and 2 ms of others for a 1024 x 512 panorama on one core.
/// Progress: the stage "measuring". Fails only when cancelled.
Result<std::vector<ExactPixel>> split_exact(const Scene& scene, const Camera& camera,
                                            const Environment& environment,
                                            const Mat3d& panorama_from_cube, int pixels_per_sphere,
                                            Progress& progress);

}  // namespace splitsum
