#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "splitsum/library/bake_library.h"

namespace splitsum::tools {

/// The results as one JSON object, for --json; tools/README.md says what is in it.
std::string library_json(const LibrarySummary& summary, std::span<const LibraryJob> jobs,
                         const std::filesystem::path& folder, bool dry_run);

}  // namespace splitsum::tools
