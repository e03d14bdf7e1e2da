#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "splitsum/base/result.h"

namespace splitsum {

/// What the system says of a file at one moment: as long as it says the same, nobody has written to
/// the file.
struct SourceStamp {
    int64_t bytes = 0;
    int64_t modified_ns = 0;  ///< since 1970
    int64_t changed_ns = 0;   ///< since 1970: also of renaming, or of setting modified_ns back
    uint64_t inode = 0;
    /// When this was asked, by our own clock. A file that was written this very moment may be written
    /// again without a difference above, so that only older files are trusted.
    int64_t asked_ns = 0;
};

/// Take it before reading the file. Fails with unreadable_input.
Result<SourceStamp> stamp_of(const std::filesystem::path& source);

/// Whether nobody wrote to the file since then. Fails with unreadable_input, saying that the file
/// changed while it was read.
Status check_unchanged(const std::filesystem::path& source, const SourceStamp& before);

/// Notes in `folder`/.source that a file with that stamp has that hash, so that it need not be read
/// again in order to know it. Where such a note is lost, nothing is but time. Fails with
/// unwritable_output.
Status remember_source(const std::filesystem::path& folder, const SourceStamp& stamp,
                       const std::string& source_hash);

/// A source's hash, and whether it is news for remember_source.
struct SourceHash {
    std::string hash;  ///< "xxh3-128:" and 32 hexadecimal digits
    SourceStamp stamp;
    bool was_read = false;
};

/// The hash of a file: from the note in `folder` if nobody wrote to the file since, which costs a
/// look at its entry, else by reading it. Fails with unreadable_input.
Result<SourceHash> hash_of_source(const std::filesystem::path& source,
                                  const std::filesystem::path& folder);

}  // namespace splitsum
