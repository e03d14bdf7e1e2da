#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "splitsum/cache/copy_detail.h"

namespace splitsum {

/// Whether `text` is 32 lowercase hexadecimal digits, as all keys and hashes here are.
bool is_digits(std::string_view text);

/// Whether a file of a baked folder may have this name: one path component without control
/// characters, not beginning with a dot.
bool is_file_name(std::string_view name);

/// A file of an entry. The entry holds the first as "0", the second as "1", ..., so that no name
/// of a user's becomes one in the cache.
struct IndexedFile {
    std::string name;
    FileSum sum;
};

/// What an entry holds: the text file "index" in it, which ends with a hash of itself.
struct EntryIndex {
    std::string key;
    std::vector<IndexedFile> files;

    /// Of all files together.
    int64_t bytes() const;
};

std::string text_of(const EntryIndex& index);

/// Nothing unless `text` is, to the last byte, the text of an index.
std::optional<EntryIndex> parse_index(const std::string& text);

}  // namespace splitsum
