#pragma once

#include <filesystem>

#include "splitsum/base/result.h"
#include "splitsum/texture/texture_asset.h"

namespace splitsum {

/// write_exr_cube for textures of six faces, write_exr_table for others.
Status write_exr(const TextureAsset& texture, const std::filesystem::path& path);

/// read_exr_cube for files marked as environment maps, read_exr_table for others.
Result<TextureAsset> read_exr(const std::filesystem::path& path);

}  // namespace splitsum
