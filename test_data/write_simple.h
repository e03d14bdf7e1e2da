#pragma once

#include <filesystem>
#include <string>

#include "splitsum/image/image.h"

namespace splitsum::test_data {

// Formats that are simple enough to write by hand, so that no library puts its version or the date
// into a file. Each returns the bytes of a whole file.

/// Radiance RGBE (Ward 1991, "Real Pixels", Graphics Gems II), run-length encoded.
std::string hdr_bytes(const Image& image);

/// Portable float map, little-endian, bottom row first.
std::string pfm_bytes(const Image& image);

enum class TiffSample { float32, uint16 };

/// Baseline TIFF 6.0, one strip, without compression. Integers hold 0 to 1.
std::string tiff_bytes(const Image& image, TiffSample sample);

/// Throws std::runtime_error when writing fails.
void write_bytes(const std::filesystem::path& path, const std::string& bytes);

}  // namespace splitsum::test_data
