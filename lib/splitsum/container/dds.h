#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

#include "splitsum/base/result.h"
#include "splitsum/texture/texture_asset.h"

namespace splitsum {

// DDS (Microsoft, "DDS File Layout", "DDS_HEADER", "DDS_HEADER_DXT10", "Programming Guide for DDS"):
// what engines load that read no KTX 2 cubemaps. A header and the texels, face by face, each face
// with all its levels. Faces +X -X +Y -Y +Z -Z, left-handed, row 0 on top: the order and the
// orientation of KTX 2, so nothing is turned.
//
// A DDS file has no place for keys and values: metadata is not written and comes back empty. Which
// roughness a level holds, and the certificate, must be kept elsewhere.

/// The bytes of a DDS file with the texture. Half floats and floats get the header of Direct3D 9,
/// which every reader knows; the other formats, and arrays, the additional one of Direct3D 10. Equal
/// textures give equal bytes.
///
/// Fails with bad_argument: a texture that is not valid.
Result<std::vector<std::byte>> encode_dds(const TextureAsset& texture);

/// The texture in the bytes of a DDS file, whoever wrote it: 2D, 2D array or cubemap with all six
/// faces, in one of pixel_formats(). Every size and count is checked before use.
///
/// Fails with unreadable_input (not a DDS file, cut short, longer than its texels, contradicting
/// itself) or unusable_input (a DDS file of a kind that this library has no use for:
/// block-compressed, 3D, an array of cubemaps, a cubemap that lacks faces, ...).
Result<TextureAsset> decode_dds(std::span<const std::byte> file);

/// encode_dds into a file, which appears complete or not at all.
Status write_dds(const TextureAsset& texture, const std::filesystem::path& path);

/// decode_dds of a file; messages begin with its path.
Result<TextureAsset> read_dds(const std::filesystem::path& path);

}  // namespace splitsum
