#pragma once

#include <vector>

#include "splitsum/filter/mis_light.h"
#include "splitsum/preview/sphere_surfaces.h"
#include "splitsum/truth/replicated_mean.h"

namespace splitsum {

/// A pixel of a sphere, and what is known of its light.
struct TruthPixel {
    int index;  ///< y * width + x
    SeenSurface seen;
    Vec3d closed_form;
    int densities;  ///< directions a point of the sequence stands for; 0 where closed_form is all
    ReplicatedMean sampled;

    Vec3d mean() const { return closed_form + sampled.mean(); }
    bool is_exact() const { return densities == 0; }
    bool is_missing() const { return !is_exact() && sampled.points() == 0; }
};

/// Pixels of one sphere that are near each other, and get the same number of points: whether they
/// need more is judged by all of them together, because a pixel that goes on until it thinks that
/// it is good stops where it flatters itself.
struct TruthTile {
    size_t begin, end;    ///< in the list of pixels
    uint32_t points = 0;  ///< of each replicate of each pixel
    double noise = 0;     ///< the mean of its pixels

    double pixels() const { return double(end - begin); }
    /// How much noise a point more takes away, but for a factor that all have in common.
    double gain() const { return noise / points; }
};

/// All pixels of a scene's spheres: those that need samples first, tile by tile.
struct TruthPixels {
    std::vector<TruthPixel> pixels;
    std::vector<TruthTile> tiles;
};

TruthPixels truth_pixels(const Scene& scene, const Camera& camera, const SphereSurfaces& surfaces,
                         const LightSampler& light);

/// The relative standard error of a pixel, as TruthPicture::noise has it. `least` is the luminance
/// that darker pixels count as.
double noise_of(const TruthPixel& pixel, double least);

/// What darker pixels count as: 1 % of the mean luminance of all.
double least_luminance(const std::vector<TruthPixel>& pixels);

/// What to do next, and what the mean noise of the tiles' pixels will then be, or less.
struct Refinement {
    std::vector<size_t> tiles;  ///< whose points are to be doubled; none where no more are possible
    double expected_noise;
};

/// Those tiles which gain more than the mean, no more than seem needed to get to `target`.
Refinement tiles_to_refine(const std::vector<TruthTile>& tiles, double target);

/// The mean noise of the tiles' pixels.
double noise_of(const std::vector<TruthTile>& tiles);

}  // namespace splitsum
