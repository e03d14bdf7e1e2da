#pragma once

#include <string>

#include "splitsum/cache/descriptor_detail.h"

// What is not an entry yet, or no longer one, is a folder of random name in "parts". A lock on the
// folder says that its maker is at work.
namespace splitsum {

/// A folder in which an entry is put together. It goes with the object unless it was moved.
class PartFolder {
public:
    /// Makes one in the cache at `root`; false with errno on failure.
    static PartFolder make(const Descriptor& root);

    PartFolder() = default;
    PartFolder(PartFolder&&) noexcept = default;
    PartFolder& operator=(PartFolder&&) = delete;
    ~PartFolder();

    explicit operator bool() const { return bool(folder_); }
    const Descriptor& folder() const { return folder_; }

    /// Makes it the folder `name` of `parent`, where there must be none or an empty one; false with
    /// errno on failure.
    bool move_to(const Descriptor& parent, const std::string& name);

private:
    Descriptor parts_, folder_;
    std::string name_;
};

/// Moves the entry `key` out of `shelf`, so that nobody meets half of it, and removes it. Does what
/// it can: without permission the entry stays. Only regular files with names that an entry has are
/// removed; a folder with anything else in it stays in "parts".
void discard_entry(const Descriptor& root, const Descriptor& shelf, const std::string& key);

/// Removes what killed processes left: at once where their lock tells that they are gone, after a
/// day where it tells nothing, as it does of another machine's processes.
void sweep_parts(const Descriptor& root);

}  // namespace splitsum
