#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "splitsum/base/result.h"

namespace splitsum {

/// Baked folders kept under what decides their bytes, in a folder that many processes and machines
/// use at once. An entry is there whole or not at all; README.md has the layout and the promises.
/// All functions may be called from several threads.
///
/// A key is a recipe (bake/recipe.h): 32 lowercase hexadecimal digits, with "xxh3-128:" in front or
/// without.
class ContentCache {
public:
    /// Opens the cache in `folder`, making folder and cache if there is nothing yet. Together the
    /// entries hold at most `most_bytes`; 0 keeps nothing, but what is there can still be fetched.
    /// Fails with bad_argument (a folder with other files in it, a cache of another version, a
    /// negative limit) or unwritable_output (it cannot be made).
    static Result<ContentCache> open(const std::filesystem::path& folder, int64_t most_bytes);

    ContentCache(ContentCache&&) noexcept;
    ContentCache& operator=(ContentCache&&) noexcept;
    ~ContentCache();

    /// Copies the entry of `key` into `into_folder`, which exists and has no files of these names:
    /// a StagedFolder, say. True: all files are there, compared by hash and on disk. False: there
    /// is no such entry, or it was damaged (it is then removed), or somebody removed it meanwhile;
    /// nothing was left in the folder. The entry counts as used now.
    ///
    /// Fails with unwritable_output (disk full, a file of that name, ...), leaving nothing, or with
    /// bad_argument for what is not a key.
    Result<bool> fetch(const std::string& key, const std::filesystem::path& into_folder) const;

    /// Keeps copies of the files `names` of `from_folder` as the entry of `key`, then removes the
    /// entries that were not used for longest while there is more than the limit. An entry that is
    /// there already stays, and counts as used now. One larger than the limit is not kept, which is
    /// no failure. That the files were made by the recipe `key` is the caller's word: store from a
    /// folder that nobody else writes to.
    ///
    /// Fails with unreadable_input (a file is missing, or changed meanwhile), unwritable_output or
    /// bad_argument. Without permission to write the first call fails and later ones do nothing.
    Status store(const std::string& key, const std::filesystem::path& from_folder,
                 std::span<const std::string> names) const;

    /// The same for every regular file in `from_folder` whose name does not begin with a dot.
    Status store(const std::string& key, const std::filesystem::path& from_folder) const;

private:
    struct State;
    explicit ContentCache(std::unique_ptr<State> state);

    std::unique_ptr<State> state_;
};

}  // namespace splitsum
