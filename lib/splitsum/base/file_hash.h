#pragma once

#include <filesystem>
#include <string>

#include "splitsum/base/result.h"

namespace splitsum {

/// The XXH3-128 hash of a file's bytes as 32 hexadecimal digits, as `xxhsum -H2` prints it: it says
/// which source an asset was made from. Not cryptographic. Cost: reads the file once.
/// Fails with unreadable_input.
Result<std::string> hash_of_file(const std::filesystem::path& path);

}  // namespace splitsum
