#pragma once

#include <cstdint>
#include <vector>

#include "splitsum/base/progress.h"
#include "splitsum/math/vec.h"
#include "splitsum/preview/camera.h"
#include "splitsum/preview/scene.h"
#include "splitsum/sphere/environment.h"

namespace splitsum {

/// How long to go on.
struct TruthPlan {
    double noise = 0.005;  ///< until TruthPicture::noise is this low, > 0
    double seconds = 0;  ///< or for so long, after which the result depends on the machine; 0: ever
    uint32_t seed = 0;   ///< other numbers, other noise
};

/// Why rendering ended.
enum class TruthEnd {
    noise_reached,
    out_of_time,
    cancelled,
    out_of_points,  ///< every pixel has as many points as there may be: the noise asked for is tiny
};

/// Spheres under the panorama itself, integrated without splitting anything. All lists have a value
/// a pixel, row 0 on top.
struct TruthPicture {
    int width = 0;
    int height = 0;
    std::vector<int> sphere_at;  ///< index into the scene, or background
    std::vector<Vec3> mean;      ///< radiance; 0 in the background and where nothing was drawn yet
    std::vector<Vec3> standard_error;  ///< of mean; 0 where exact, infinite where not yet drawn
    std::vector<int64_t> samples;      ///< directions drawn; 0 where it is exact

    /// The mean over sampled pixels of s / max(Y, least_share of the mean Y of all spheres' pixels), with Y
    /// the luminance and s its standard error (its root taken without bias); 0 where nothing needed
    /// samples. Infinite as long as a pixel is missing.
    double noise = 0;
    int passes = 0;
    int64_t total_samples = 0;
    TruthEnd end = TruthEnd::noise_reached;

    static constexpr int background = -1;
    static constexpr double least_share = 0.01;
};

/// Renders in passes, each of which doubles the samples of those tiles of 8 x 8 pixels of a sphere
/// whose noise gains most by it. Which tiles these are depends on what was found before, and on
/// nothing else: the same picture for every number of threads, unless it is cut short.
///
/// Cancelled or out of time, it gives the picture so far. Progress: the stage "integrating", in
/// equal steps of (plan.noise / noise)², the share of the samples that random points would have
/// needed. Memory: 300 bytes a pixel of spheres. Stopping waits for the doubling of a pixel, at
/// most about a second. `panorama_from_cube`: sphere/orientation.h.
TruthPicture truth_picture(const Scene& scene, const Camera& camera, const Environment& environment,
                           const Mat3d& panorama_from_cube, const TruthPlan& plan,
                           Progress& progress);

}  // namespace splitsum
