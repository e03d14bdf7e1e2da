#include "asset_file.h"

#include "splitsum/container/containers.h"
#include "splitsum/report/harmonics_file.h"

namespace splitsum::tools {
namespace {

Result<AssetFile> read_series(const std::filesystem::path& path) {
    auto file = read_harmonics(path);
    if (!file) return file.error();
    AssetFile asset;
    asset.harmonics = std::move(file->harmonics);
    asset.facts = std::move(file->facts);
    return asset;
}

}  // namespace

Result<AssetFile> read_asset(const std::filesystem::path& path) {
    if (path.extension() == ".json") return read_series(path);
    auto texture = read_texture(path);
    if (!texture) return texture.error();
    AssetFile asset;
    // Files of other programs say nothing of this; then the caller must know.
    if (const auto facts = facts_of(texture->metadata)) asset.facts = *facts;
    if (texture->face_count == 1) {
        auto table = table_of(*texture);
        if (!table) return table.error();
        asset.table = std::move(*table);
        return asset;
    }
    auto levels = cubemaps_of(*texture);
    if (!levels) return levels.error();
    asset.levels = std::move(*levels);
    asset.texture = std::move(*texture);
    return asset;
}

}  // namespace splitsum::tools
