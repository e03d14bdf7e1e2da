#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "splitsum/base/result.h"

namespace splitsum {

/// One Zstandard frame with the content's size and checksum. `level` in [1, 22].
/// Fails with internal when the library does.
Result<std::vector<std::byte>> zstd_compress(std::span<const std::byte> content, int level);

/// The content of Zstandard frames that hold exactly `size` bytes. A frame that says another size is
/// refused before any memory is taken, one that lies about it when `size` is passed.
/// Fails with unreadable_input.
Result<std::vector<std::byte>> zstd_decompress(std::span<const std::byte> frames, size_t size);

}  // namespace splitsum
