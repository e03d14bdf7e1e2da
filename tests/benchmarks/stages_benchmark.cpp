// The stages around the filters, each on its own: from 1024 x 512 texels to the bytes of a file.

#include <benchmark/benchmark.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "counters.h"
#include "splitsum/base/text.h"
#include "splitsum/container/ktx2.h"
#include "splitsum/filter/asset_levels.h"
#include "splitsum/filter/harmonics_of_environment.h"
#include "splitsum/filter/irradiance_harmonics.h"
#include "splitsum/sphere/area_filter.h"
#include "splitsum/sphere/ring_pyramid.h"
#include "splitsum/texture/texture_asset.h"
#include "support/skies.h"

namespace splitsum::benchmarks {
namespace {

constexpr int environment_height = 512;

const Environment& sunset() {
    static const Environment environment = tests::sunset_sky(environment_height);
    return environment;
}

double texels_of(const Environment& environment) {
    return double(environment.width()) * environment.height();
}

// |a / b - 1| of the channel where it is largest.
double relative_difference(const Vec3d& a, const Vec3d& b) {
    double worst = 0;
    for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(a[c] / b[c] - 1));
    return worst;
}

// A chain as long as the real one, with light in it that needs the whole range of a format.
const std::vector<Cubemap>& chain() {
    static const std::vector<Cubemap> levels = [] {
        NoProgress progress;
        std::vector<Cubemap> made;
        for (int face_size = 256; face_size >= 4; face_size /= 2)
            made.push_back(*area_filtered_cubemap(sunset(), face_size, Mat3d(1), progress));
        return made;
    }();
    return levels;
}

TextureAsset encoded_chain(PixelFormat format) {
    std::vector<EncodeCounts> counts;
    return texture_from_cubemaps(chain(), format, counts);
}

double bytes_of(const TextureAsset& texture) {
    double bytes = 0;
    for (const auto& level : texture.levels) bytes += double(level.size());
    return bytes;
}

void area_filter(benchmark::State& state) {
    NoProgress progress;
    Cubemap mirror;
    for (auto _ : state)
        mirror = *area_filtered_cubemap(sunset(), int(state.range(0)), Mat3d(1), progress);
    show_rate(state, "texels/s", double(mirror.texels.size()));
    state.counters["energy_error"] =
        relative_difference(mean_radiance(mirror), mean_radiance(sunset()));
}
BENCHMARK(area_filter)
    ->ArgName("face_size")
    ->Arg(64)
    ->Arg(256)
    ->Arg(512)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

void pyramid_of_rings(benchmark::State& state) {
    const Environment environment = tests::sunset_sky(int(state.range(0)));
    RingPyramid pyramid;
    for (auto _ : state) pyramid = ring_pyramid(environment);
    show_rate(state, "texels/s", texels_of(environment));
    state.counters["energy_error"] =
        relative_difference(mean_radiance(pyramid.levels.back()), mean_radiance(environment));
}
BENCHMARK(pyramid_of_rings)
    ->ArgName("rows")
    ->Arg(512)
    ->Arg(2048)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

// Band 0 is the mean radiance: what its error shows is the energy.
void harmonics(benchmark::State& state) {
    std::vector<Vec3d> coefficients;
    for (auto _ : state)
        coefficients = harmonics_of_environment(sunset(), int(state.range(0)), Mat3d(1));
    show_rate(state, "texels/s", texels_of(sunset()));
    const double y00 = 1 / std::sqrt(4 * std::numbers::pi);
    state.counters["energy_error"] =
        relative_difference(coefficients[0] * y00, mean_radiance(sunset()));
}
BENCHMARK(harmonics)->ArgName("order")->Arg(2)->Arg(8)->Arg(32)->UseRealTime()->Unit(
    benchmark::kMillisecond);

void encode_chain(benchmark::State& state, PixelFormat format) {
    TextureAsset texture;
    for (auto _ : state) texture = encoded_chain(format);
    show_rate(state, "bytes/s", bytes_of(texture));

    double sum = 0, reference = 0;
    const std::vector<Cubemap> decoded = *cubemaps_of(texture);
    for (size_t l = 0; l < decoded.size(); ++l)
        for (size_t i = 0; i < decoded[l].texels.size(); ++i) {
            // Saturated suns are counted by the encoder; the figure here is that of the rounding.
            const Vec3 truth = min(chain()[l].texels[i], Vec3(64512));
            sum += std::pow(double(length(min(decoded[l].texels[i], Vec3(64512)) - truth)), 2);
            reference += std::pow(double(length(truth)), 2);
        }
    state.counters["rel_rms"] = std::sqrt(sum / reference);
}

void encode_file(benchmark::State& state, bool zstd) {
    const TextureAsset texture = encoded_chain(PixelFormat::rgba16f);
    size_t size = 0;
    for (auto _ : state) size = encode_ktx2(texture, {zstd})->size();
    show_rate(state, "bytes/s", bytes_of(texture));
    state.counters["size_ratio"] = double(size) / bytes_of(texture);
}

void write_file(benchmark::State& state) {
    const TextureAsset texture = encoded_chain(PixelFormat::rgba16f);
    const auto path =
        std::filesystem::temp_directory_path() / cat("splitsum-benchmark-", getpid(), ".ktx2");
    for (auto _ : state)
        if (const Status written = write_ktx2(texture, path); !written)
            return state.SkipWithError(written.error().message.c_str());
    show_rate(state, "bytes/s", bytes_of(texture));
    if (read_ktx2(path)->levels != texture.levels)
        state.SkipWithError("the file holds something else");
    std::filesystem::remove(path);
}
BENCHMARK(write_file)->UseRealTime()->Unit(benchmark::kMillisecond);

const bool registered = [] {
    for (const PixelFormatInfo& info : pixel_formats())
        if (holds_colours(info))
            benchmark::RegisterBenchmark(cat("encode_chain/", info.name).c_str(), encode_chain,
                                         info.format)
                ->UseRealTime()
                ->Unit(benchmark::kMillisecond);
    for (const bool zstd : {false, true})
        benchmark::RegisterBenchmark(zstd ? "encode_ktx2/zstd" : "encode_ktx2/plain", encode_file,
                                     zstd)
            ->UseRealTime()
            ->Unit(benchmark::kMillisecond);
    return true;
}();

}  // namespace
}  // namespace splitsum::benchmarks
