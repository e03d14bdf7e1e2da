#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

#include "splitsum/base/result.h"
#include "splitsum/texture/texture_asset.h"

namespace splitsum {

// KTX 2.0 (Khronos, "KTX File Format Specification 2.0"): what engines load without a decoder of
// images. A file says its Vulkan format, describes the bits of a texel in a data format descriptor,
// carries keys with values, and stores the levels as the GPU reads them, smallest level first.

struct Ktx2Options {
    /// Zstandard supercompression, each level on its own, lossless. Compressing takes several times
    /// as long as encoding the texels.
    bool zstd = false;
    /// 1 (fastest) to 22 (smallest, hundreds of megabytes of memory while compressing).
    int zstd_level = 3;
};

/// The bytes of a KTX 2 file with the texture and its metadata. Keys are sorted as the
/// specification asks; KTXorientation "rd" (row 0 on top) and KTXwriter replace what the metadata
/// says. Equal arguments give equal bytes.
///
/// Fails with bad_argument: a texture that is not valid, a level of compression out of range, a key
/// that is empty or holds a NUL.
Result<std::vector<std::byte>> encode_ktx2(const TextureAsset& texture,
                                           const Ktx2Options& options = {});

/// The texture in the bytes of a KTX 2 file, whoever wrote it: uncompressed or Zstandard, 2D, 2D
/// array or cubemap, in one of pixel_formats(). Every offset, length and count is checked before use.
///
/// Fails with unreadable_input (not a KTX 2 file, cut short, contradicting itself) or unusable_input
/// (a KTX 2 file of a kind that this library has no use for: block-compressed, 3D, an array of cubemaps, rows
/// bottom up, ...).
Result<TextureAsset> decode_ktx2(std::span<const std::byte> file);

/// encode_ktx2 into a file, which appears complete or not at all.
Status write_ktx2(const TextureAsset& texture, const std::filesystem::path& path,
                  const Ktx2Options& options = {});

/// decode_ktx2 of a file; messages begin with its path.
Result<TextureAsset> read_ktx2(const std::filesystem::path& path);

}  // namespace splitsum
