#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <string>

#include "splitsum/base/result.h"

namespace splitsum {

/// What OpenColorIO configs say, as hashes: of the config itself, of every file with a table or a
/// curve that it names, and of the environment variables it declares; not of where any of them lies.
/// Equal hashes convert colours equally, on every machine.
///
/// Each config is read once in the life of this; all functions may be called from any thread.
class ConfigHashes {
public:
    /// "xxh3-128:" and 32 hexadecimal digits; "built-in" for the empty path. A file that the config
    /// names and does not have counts as missing. Fails with unreadable_input.
    Result<std::string> of(const std::filesystem::path& config);

private:
    std::mutex mutex_;
    std::map<std::filesystem::path, std::string> known_;
};

}  // namespace splitsum
