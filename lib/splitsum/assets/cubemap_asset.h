#pragma once

#include <span>
#include <vector>

#include "splitsum/base/result.h"
#include "splitsum/report/asset_facts.h"
#include "splitsum/sphere/cubemap.h"
#include "splitsum/texture/texture_asset.h"

namespace splitsum {

/// A cubemap as it will be stored, and what an engine reads back from it: what is measured is what
/// is in the file.
struct CubemapAsset {
    TextureAsset texture;              ///< with the facts as metadata
    std::vector<EncodeCounts> counts;  ///< one a level
    std::vector<Cubemap> levels;       ///< decoded
};

/// Fails with bad_argument for a format without three channels.
Result<CubemapAsset> cubemap_asset(std::span<const Cubemap> levels, PixelFormat format,
                                   const AssetFacts& facts);

}  // namespace splitsum
