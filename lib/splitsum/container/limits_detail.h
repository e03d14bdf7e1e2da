#pragma once

#include <cstdint>

#include "splitsum/base/result.h"
#include "splitsum/base/text.h"
#include "splitsum/texture/texture_asset.h"

namespace splitsum {

// A file may state any size; what is beyond these is refused before memory is taken.

/// The widest texture that any GPU takes (Vulkan's maxImageDimension2D), in texels.
inline constexpr int largest_edge = 32768;

/// The most layers of an array, with room to spare beyond Vulkan's required 256.
inline constexpr uint32_t most_layers = 4096;

/// Bytes of decoded texels. A cubemap of 8192² half floats with all its levels takes 4.3e9.
inline constexpr uint64_t largest_texture = uint64_t{8} << 30;

/// Whether a texture with that format, size and number of levels stays below `largest_texture`.
/// Fails with unusable_input.
inline Status check_memory(const TextureAsset& texture) {
    uint64_t total = 0;
    for (size_t level = 0; level < texture.levels.size(); ++level)
        total += bytes_of_level(texture, static_cast<int>(level));
    if (total > largest_texture)
        return Error{ErrorKind::unusable_input,
                     cat("its texels take ", total, " bytes; usable are up to ", largest_texture)};
    return ok;
}

}  // namespace splitsum
