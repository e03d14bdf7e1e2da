#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

#include "splitsum/base/result.h"
#include "splitsum/texture/texture_asset.h"

namespace splitsum {

/// Writes what an encoder returned to `path`, whole or not at all; its error names the path.
Status write_encoded(const std::filesystem::path& path,
                     const Result<std::vector<std::byte>>& encoded);

/// What `decode` makes of the bytes of a file; its error names the path.
Result<TextureAsset> read_encoded(const std::filesystem::path& path,
                                  Result<TextureAsset> (*decode)(std::span<const std::byte>));

}  // namespace splitsum
