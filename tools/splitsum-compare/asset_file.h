#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "splitsum/base/result.h"
#include "splitsum/filter/irradiance_harmonics.h"
#include "splitsum/image/table.h"
#include "splitsum/report/asset_facts.h"
#include "splitsum/sphere/cubemap.h"
#include "splitsum/texture/texture_asset.h"

namespace splitsum::tools {

/// A file as splitsum-compare sees it: one of cubemap levels, a table or harmonics.
struct AssetFile {
    std::vector<Cubemap> levels;
    std::optional<Table> table;
    std::optional<IrradianceHarmonics> harmonics;
    std::optional<AssetFacts> facts;      ///< where the file says them
    std::optional<TextureAsset> texture;  ///< what `levels` are decoded from
};

/// Reads a texture (.ktx2, .exr, .dds) or harmonics (.json).
Result<AssetFile> read_asset(const std::filesystem::path& path);

}  // namespace splitsum::tools
