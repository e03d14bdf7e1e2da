#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

#include "splitsum/base/result.h"
#include "splitsum/texture/texture_asset.h"

namespace splitsum {

// Tables as plain EXR images, row 0 on top: channels R and G, or R, G, B and A, by what the format
// stores. The layers of an array are EXR layers: layer0.R, ..., layer1.A.

/// The bytes of an EXR file with the table: half floats or floats as its format has them, ZIP
/// compression, the metadata as text attributes. Fails with bad_argument for other textures.
Result<std::vector<std::byte>> encode_exr_table(const TextureAsset& texture);

/// The channels R, G, B, A of an EXR image, R and G where one of the others is missing, or those of
/// layer0, layer1, ...: half floats when all of them are, otherwise floats.
/// Fails with unreadable_input or, for an EXR file of another kind, with unusable_input.
Result<TextureAsset> decode_exr_table(std::span<const std::byte> file);

/// encode_exr_table into a file, which appears complete or not at all.
Status write_exr_table(const TextureAsset& texture, const std::filesystem::path& path);

/// decode_exr_table of a file; messages begin with its path.
Result<TextureAsset> read_exr_table(const std::filesystem::path& path);

}  // namespace splitsum
