#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

#include "splitsum/base/result.h"
#include "splitsum/texture/texture_asset.h"

namespace splitsum {

// Tables of two channels as plain EXR images: channels R and G, row 0 on top.

/// The bytes of an EXR file with the table: half floats for rg16f, floats for rg32f, ZIP compression,
/// the metadata as text attributes. Fails with bad_argument for other textures.
Result<std::vector<std::byte>> encode_exr_table(const TextureAsset& texture);

/// The channels R and G of an EXR image: rg16f when both are half floats, otherwise rg32f.
/// Fails with unreadable_input or, for an EXR file of another kind, with unusable_input.
Result<TextureAsset> decode_exr_table(std::span<const std::byte> file);

/// encode_exr_table into a file, which appears complete or not at all.
Status write_exr_table(const TextureAsset& texture, const std::filesystem::path& path);

/// decode_exr_table of a file; messages begin with its path.
Result<TextureAsset> read_exr_table(const std::filesystem::path& path);

}  // namespace splitsum
