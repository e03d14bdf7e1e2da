#include "splitsum/preview/truth_picture.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <numeric>

#include "splitsum/base/parallel.h"
#include "splitsum/filter/mis_estimate.h"
#include "splitsum/preview/share_progress_detail.h"
#include "splitsum/preview/truth_pixels_detail.h"

namespace splitsum {
namespace {

constexpr uint32_t first_points = 16;  // of each replicate

// Says when to stop, and remembers why.
class StopWatch {
public:
    StopWatch(const TruthPlan& plan, const Progress& progress)
        : progress_(progress), seconds_(plan.seconds) {}

    bool says_stop() {
        if (stopped_) return true;
        if (progress_.cancelled())
            stop(TruthEnd::cancelled);
        else if (seconds_.count() > 0 && std::chrono::steady_clock::now() - start_ > seconds_)
            stop(TruthEnd::out_of_time);
        return stopped_;
    }

    bool stopped() const { return stopped_; }
    TruthEnd reason() const { return reason_; }

private:
    void stop(TruthEnd reason) {
        reason_ = reason;
        stopped_ = true;
    }

    const Progress& progress_;
    std::chrono::duration<double> seconds_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::atomic<TruthEnd> reason_ = TruthEnd::noise_reached;
    std::atomic<bool> stopped_ = false;
};

class TruthRendering {
public:
    TruthRendering(const SphereSurfaces& surfaces, const LightSampler& light, TruthPixels work,
                   const TruthPlan& plan, Progress& progress)
        : surfaces_(surfaces),
          light_(light),
          work_(std::move(work)),
          plan_(plan),
          watch_(plan, progress),
          shares_(progress, "integrating") {}

    TruthPicture run(int width, int height);

private:
    std::vector<size_t> all_tiles() const {
        std::vector<size_t> all(work_.tiles.size());
        std::iota(all.begin(), all.end(), size_t(0));
        return all;
    }

    // The share of samples that random points would have taken by now.
    double share_at(double noise) const {
        const double left = plan_.noise / noise;
        return std::min(left * left, 1.0);
    }

    void refine(const std::vector<size_t>& tiles, double from, double to);
    double judge();
    TruthPicture so_far(int width, int height) const;

    const SphereSurfaces& surfaces_;
    const LightSampler& light_;
    TruthPixels work_;
    TruthPlan plan_;
    StopWatch watch_;
    ShareProgress shares_;
};

// Doubles the points of every pixel of the tiles. Between `from` and `to` is where progress is
// expected meanwhile.
void TruthRendering::refine(const std::vector<size_t>& tiles, double from, double to) {
    std::vector<size_t> pixels;
    for (const size_t i : tiles) {
        TruthTile& tile = work_.tiles[i];
        tile.points = std::max(2 * tile.points, first_points);
        for (size_t pixel = tile.begin; pixel < tile.end; ++pixel) pixels.push_back(pixel);
    }
    std::atomic<int64_t> done = 0;
    parallel_rows(int(pixels.size()), [&](int i) {
        if (watch_.says_stop()) return;
        TruthPixel& pixel = work_.pixels[pixels[size_t(i)]];
        const SurfaceLight light(light_, surfaces_.at(pixel.seen));
        const uint32_t points = std::max(2 * pixel.sampled.points(), first_points);
        pixel.sampled.extend(light, {plan_.seed, uint32_t(pixel.index)}, points, PowerShare());
        shares_.reach(from + (to - from) * double(++done) / double(pixels.size()));
    });
}

// The noise of the tiles, by what all pixels are now, and of the picture.
double TruthRendering::judge() {
    const double least = least_luminance(work_.pixels);
    parallel_rows(int(work_.tiles.size()), [&](int i) {
        TruthTile& tile = work_.tiles[size_t(i)];
        double noise = 0;
        for (size_t pixel = tile.begin; pixel < tile.end; ++pixel)
            noise += noise_of(work_.pixels[pixel], least);
        tile.noise = noise / tile.pixels();
    });
    return noise_of(work_.tiles);
}

TruthPicture TruthRendering::run(int width, int height) {
    std::vector<size_t> tiles = all_tiles();
    double noise = 0, share = 0, expected_share = 0;
    int passes = 0;
    while (!tiles.empty()) {
        refine(tiles, share, expected_share);
        noise = judge();
        if (watch_.stopped()) break;
        ++passes;
        if (noise <= plan_.noise) break;
        Refinement next = tiles_to_refine(work_.tiles, plan_.noise);
        tiles = std::move(next.tiles);
        share = share_at(noise);
        expected_share = share_at(next.expected_noise);
    }
    TruthPicture picture = so_far(width, height);
    picture.noise = noise;
    picture.passes = passes;
    picture.end = watch_.stopped()       ? watch_.reason()
                  : noise <= plan_.noise ? TruthEnd::noise_reached
                                         : TruthEnd::out_of_points;
    if (!watch_.stopped()) shares_.reach(1);
    return picture;
}

TruthPicture TruthRendering::so_far(int width, int height) const {
    const size_t count = size_t(width) * size_t(height);
    TruthPicture picture{.width = width,
                         .height = height,
                         .sphere_at = std::vector<int>(count, TruthPicture::background),
                         .mean = std::vector<Vec3>(count, Vec3(0)),
                         .standard_error = std::vector<Vec3>(count, Vec3(0)),
                         .samples = std::vector<int64_t>(count)};
    for (const TruthPixel& pixel : work_.pixels) {
        const size_t i = size_t(pixel.index);
        picture.sphere_at[i] = pixel.seen.sphere;
        if (pixel.is_missing()) {
            picture.standard_error[i] = Vec3(std::numeric_limits<float>::infinity());
            continue;
        }
        picture.mean[i] = Vec3(pixel.mean());
        picture.standard_error[i] = Vec3(sqrt(pixel.sampled.variance_of_mean()));
        picture.samples[i] =
            int64_t(pixel.sampled.points()) * ReplicatedMean::replicates * pixel.densities;
        picture.total_samples += picture.samples[i];
    }
    return picture;
}

}  // namespace

TruthPicture truth_picture(const Scene& scene, const Camera& camera, const Environment& environment,
                           const Mat3d& panorama_from_cube, const TruthPlan& plan,
                           Progress& progress) {
    const SphereSurfaces surfaces(scene, panorama_from_cube);
    const LightSampler light(environment);
    return TruthRendering(surfaces, light, truth_pixels(scene, camera, surfaces, light), plan,
                          progress)
        .run(camera.width, camera.height);
}

}  // namespace splitsum
