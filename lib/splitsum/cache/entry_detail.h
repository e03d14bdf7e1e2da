#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "splitsum/base/result.h"
#include "splitsum/cache/descriptor_detail.h"
#include "splitsum/cache/entry_index_detail.h"

namespace splitsum {

/// Where the entries whose keys begin alike are: "entries/ab". False with errno if it is missing.
Descriptor open_shelf(const Descriptor& root, const std::string& key);

/// The same, made if it is missing.
Descriptor make_and_open_shelf(const Descriptor& root, const std::string& key);

/// What became of an attempt to read an entry.
enum class Found {
    whole,
    damaged,      ///< not what was stored, and never will be again
    unreachable,  ///< it may be whole, but cannot be read now: permissions, a lost connection
};

/// The index of an entry.
struct FoundIndex {
    Found found;
    EntryIndex index;  ///< of a whole one
};
FoundIndex read_index(const Descriptor& entry, const std::string& key);

/// Copies what the index lists into `folder` and compares the copies with it. On anything but whole
/// it leaves no file. Fails with unwritable_output.
Result<Found> fetch_files(const Descriptor& entry, const EntryIndex& index,
                          const std::filesystem::path& folder);

/// Copies the files `names` of `from` into the folder of a new entry and writes its index. Fails
/// with unreadable_input, also when a file changed meanwhile, or unwritable_output, which names
/// `cache`.
Result<EntryIndex> fill_entry(const Descriptor& entry, const std::string& key,
                              const std::filesystem::path& from, std::span<const std::string> names,
                              const std::filesystem::path& cache);

/// Makes an entry the most recently used one, where the cache can be written to.
void mark_used(const Descriptor& entry);

}  // namespace splitsum
