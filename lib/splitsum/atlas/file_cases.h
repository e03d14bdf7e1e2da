#pragma once

#include <optional>
#include <string>
#include <vector>

#include "splitsum/image/image.h"

namespace splitsum {

/// What the reader of panoramas must do with a file.
enum class Reading {
    light,   ///< it is read
    refusal  ///< it is refused with a sentence
};

/// A file, and what must become of it.
struct FileCase {
    std::string name;   ///< of the file
    std::string about;  ///< what is the matter with it
    std::string bytes;
    Reading as_it_is = Reading::light;
    Reading repaired = Reading::light;  ///< with --repair
    std::optional<Image> truth = {};    ///< its pixels, where it is read as it is
};

/// Every file; deterministic, a few kilobytes each.
std::vector<FileCase> file_cases();

}  // namespace splitsum
