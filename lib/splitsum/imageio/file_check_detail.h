#pragma once

#include <filesystem>

#include "splitsum/base/result.h"

namespace splitsum {

/// Fails with unreadable_input and one sentence where `path` is no file with bytes that we may
/// read, or is a TIFF file that ends before its pixels do (OpenImageIO returns black rows there
/// without an error). Reads a few kilobytes.
Status check_file(const std::filesystem::path& path);

}  // namespace splitsum
