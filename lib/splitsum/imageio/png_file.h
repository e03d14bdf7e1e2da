#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "splitsum/base/result.h"

namespace splitsum {

/// Writes a PNG of 8-bit RGB, row 0 at the top, marked as sRGB: the file appears complete or not at
/// all. `rgb` holds 3 * width * height values. Fails with unwritable_output.
Status write_png_rgb8(const std::filesystem::path& path, int width, int height,
                      std::span<const uint8_t> rgb);

}  // namespace splitsum
