#include "splitsum/preview/truth_pixels_detail.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <tuple>

#include "splitsum/base/parallel.h"
#include "splitsum/image/luminance.h"
#include "splitsum/preview/truth_picture.h"

namespace splitsum {
namespace {

constexpr int tile_size = 8;
constexpr uint32_t most_points = 1u << 18;  // a doubling must not keep anybody waiting
const Vec3d luminance_weights(luminance({1, 0, 0}), luminance({0, 1, 0}), luminance({0, 0, 1}));

// Doubling the points divides noise by this at least: evenly spread points do better.
const double doubled = std::sqrt(2.0);

// The root of an estimated variance is too small on average, by this factor for the 7 degrees of
// freedom of 8 replicates: sqrt(2 / 7) gamma(4) / gamma(7 / 2).
constexpr double mean_of_root = 0.96503;
static_assert(ReplicatedMean::replicates == 8);

// Pixels of a tile, and of nothing else, have equal keys.
auto tile_key(const TruthPixel& pixel, int width) {
    const int x = pixel.index % width, y = pixel.index / width;
    return std::tuple(pixel.is_exact(), pixel.seen.sphere, y / tile_size, x / tile_size);
}

std::vector<TruthPixel> seen_pixels(const Scene& scene, const Camera& camera,
                                    const SphereSurfaces& surfaces, const LightSampler& light) {
    std::vector<std::vector<TruthPixel>> rows(size_t(camera.height));
    parallel_rows(camera.height, [&](int y) {
        for (int x = 0; x < camera.width; ++x) {
            const auto seen = first_surface(scene, camera, x, y);
            if (!seen) continue;
            const SurfaceLight lit(light, surfaces.at(*seen));
            rows[size_t(y)].push_back(
                {y * camera.width + x, *seen, lit.closed_form(), lit.densities(), {}});
        }
    });
    std::vector<TruthPixel> pixels;
    for (const auto& row : rows) pixels.insert(pixels.end(), row.begin(), row.end());
    return pixels;
}

}  // namespace

TruthPixels truth_pixels(const Scene& scene, const Camera& camera, const SphereSurfaces& surfaces,
                         const LightSampler& light) {
    TruthPixels result{seen_pixels(scene, camera, surfaces, light), {}};
    const auto key = [&](const TruthPixel& pixel) { return tile_key(pixel, camera.width); };
    std::ranges::stable_sort(result.pixels, {}, key);
    for (size_t i = 0; i < result.pixels.size() && !result.pixels[i].is_exact(); ++i) {
        if (i == 0 || key(result.pixels[i]) != key(result.pixels[i - 1]))
            result.tiles.push_back({i, i});
        result.tiles.back().end = i + 1;
    }
    return result;
}

double noise_of(const TruthPixel& pixel, double least) {
    if (pixel.is_missing()) return std::numeric_limits<double>::infinity();
    const double error =
        std::sqrt(pixel.sampled.variance_of_mean(luminance_weights)) / mean_of_root;
    return error == 0 ? 0 : error / std::max(luminance(pixel.mean()), least);
}

double least_luminance(const std::vector<TruthPixel>& pixels) {
    const double sum = std::accumulate(
        pixels.begin(), pixels.end(), 0.0,
        [](double before, const TruthPixel& pixel) { return before + luminance(pixel.mean()); });
    return pixels.empty() ? 0 : TruthPicture::least_share * sum / double(pixels.size());
}

double noise_of(const std::vector<TruthTile>& tiles) {
    double noise = 0, pixels = 0;
    for (const TruthTile& tile : tiles) {
        noise += tile.noise * tile.pixels();
        pixels += tile.pixels();
    }
    return pixels == 0 ? 0 : noise / pixels;
}

Refinement tiles_to_refine(const std::vector<TruthTile>& tiles, double target) {
    std::vector<size_t> open;
    double gains = 0, open_pixels = 0, all_pixels = 0;
    for (size_t i = 0; i < tiles.size(); ++i) {
        const TruthTile& tile = tiles[i];
        all_pixels += tile.pixels();
        if (tile.points >= most_points) continue;
        open.push_back(i);
        gains += tile.gain() * tile.pixels();
        open_pixels += tile.pixels();
    }
    std::ranges::stable_sort(open, std::greater(), [&](size_t i) { return tiles[i].gain(); });
    Refinement next{{}, noise_of(tiles)};
    for (const size_t i : open) {
        const TruthTile& tile = tiles[i];
        if (next.expected_noise <= target || tile.gain() * open_pixels < gains) break;
        next.tiles.push_back(i);
        next.expected_noise -= tile.noise * (1 - 1 / doubled) * tile.pixels() / all_pixels;
    }
    return next;
}

}  // namespace splitsum
