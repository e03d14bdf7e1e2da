#include "splitsum/chart/storage.h"

#include "splitsum/chart/level_count.h"
#include "splitsum/chart/stop_only.h"
#include "splitsum/filter/asset_levels.h"
#include "splitsum/texture/texture_asset.h"

namespace splitsum {
namespace {

std::vector<PixelFormatInfo> formats() {
    std::vector<PixelFormatInfo> small;
    for (const PixelFormatInfo& format : pixel_formats())
        if (holds_colours(format) && format.format != PixelFormat::rgba32f) small.push_back(format);
    return small;
}

Result<StoredChain> stored(const std::vector<Cubemap>& levels, const PixelFormatInfo& format,
                           const ReconstructionProbes& probes) {
    std::vector<EncodeCounts> counts;
    const TextureAsset texture = texture_from_cubemaps(levels, format.format, counts);
    const auto read = cubemaps_of(texture);
    if (!read) return read.error();
    StoredChain chain;
    chain.format = format.name;
    chain.face_size = levels[0].face_size;
    chain.levels = int(levels.size());
    for (const auto& level : texture.levels) chain.bytes += int64_t(level.size());
    for (const EncodeCounts& count : counts) chain.saturated += count.saturated;
    chain.errors = reconstruction_error(*read, {}, probes);
    return chain;
}

}  // namespace

int storage_steps(const ChartPlan& plan) {
    return plan.storage_probes * int(roughness_bands().size()) + int(plan.storage_sizes.size());
}

Status measure_storage(const NamedLight& light, const ChartPlan& plan,
                       std::vector<StoredChain>& chains, Progress& progress) {
    StopOnly stop(progress);
    const auto probes = reconstruction_probes(light.source.environment, Mat3d(1), roughness_bands(),
                                              plan.storage_probes, stop);
    if (!probes) return probes.error();
    progress.advance(storage_steps(plan) - int(plan.storage_sizes.size()));
    for (const int size : plan.storage_sizes) {
        LevelsPlan levels;
        levels.specular = SpecularPlan{size, usual_level_count(size), {}};
        const auto made = filter_levels(light.source, levels, stop);
        if (!made) return made.error();
        for (const PixelFormatInfo& format : formats()) {
            auto chain = stored(made->specular, format, *probes);
            if (!chain) return chain.error();
            chain->panorama = light.name;
            chains.push_back(std::move(*chain));
        }
        progress.advance(1);
    }
    return ok;
}

}  // namespace splitsum
