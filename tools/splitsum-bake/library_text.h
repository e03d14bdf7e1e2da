#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "splitsum/library/bake_library.h"

// Results as lines for people, each with its end.

namespace splitsum::tools {

/// Of more panoramas than this, each has one line, and those that are up to date none.
inline constexpr size_t most_in_full = 20;

/// What became of a panorama, whose results are in `folder`; "" where there is nothing to say here:
/// failures are told on stderr.
std::string item_text(const LibraryItem& item, const std::filesystem::path& folder, bool briefly,
                      bool dry_run);

/// What became of the table.
std::string table_text(const TableResult& table, bool dry_run);

/// How many were baked, up to date, ..., with megabytes, time, and the worst error and where it is.
std::string counts_text(const LibrarySummary& summary, std::span<const LibraryJob> jobs,
                        const std::filesystem::path& folder, bool dry_run);

}  // namespace splitsum::tools
