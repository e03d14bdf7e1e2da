#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "splitsum/base/result.h"

namespace splitsum {

/// The bytes of a PNG of 8-bit RGB, row 0 at the top, marked as sRGB. `rgb` holds 3 * width * height
/// values. Fails with internal where libpng does.
Result<std::vector<std::byte>> png_of(int width, int height, std::span<const uint8_t> rgb);

/// Writes a PNG of 8-bit RGB, row 0 at the top, marked as sRGB, through libpng, for programs that
/// read no images and so need nothing larger. `rgb` holds 3 * width * height values. The file
/// appears complete or not at all. Fails with unwritable_output.
Status write_png(const std::filesystem::path& path, int width, int height,
                 std::span<const uint8_t> rgb);

}  // namespace splitsum
