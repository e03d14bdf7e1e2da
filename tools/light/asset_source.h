#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/options.h"
#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/panorama/panorama.h"
#include "splitsum/report/asset_facts.h"

// The panorama that an asset was made from, beside the asset.

namespace splitsum::tools {

/// A panorama as the asset's light was.
struct AssetSource {
    Panorama panorama;
    bool is_source;                  ///< it has the hash that the asset names
    std::vector<std::string> notes;  ///< of reading, and where it is another panorama
};

/// Reads `panorama` with the exposure that the asset names, unless the command line has one. `facts`
/// are what the asset's file says, if it does. Fails as read_panorama does.
Result<AssetSource> read_asset_source(const std::filesystem::path& panorama,
                                      const std::optional<AssetFacts>& facts,
                                      const ReadingOptions& reading, Progress& progress);

}  // namespace splitsum::tools
