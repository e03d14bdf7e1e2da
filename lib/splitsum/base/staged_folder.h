#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "splitsum/base/file_lock.h"
#include "splitsum/base/result.h"

namespace splitsum {

/// A hidden folder inside the one where several files shall appear together: they are written into
/// it, and moved out when all of them are complete. Going out of scope before that removes it, and
/// the folder itself if it was made for this, so that a failure leaves what was there before.
///
/// Any number of threads, processes and machines may stage files for one folder at once. What a
/// killed process leaves behind is removed when files are next staged there.
class StagedFolder {
public:
    /// Makes `folder` if it is missing, and the hidden one in it. Fails with unwritable_output.
    static Result<StagedFolder> create(const std::filesystem::path& folder);

    StagedFolder(StagedFolder&& other) noexcept;
    StagedFolder& operator=(StagedFolder&&) = delete;
    ~StagedFolder();

    /// Where to write the files.
    const std::filesystem::path& path() const { return staging_; }

    /// Moves every file to its place, over older ones, and waits until that is on the disk. The file
    /// called `last` says that the others are there: an older one goes first, the new one comes
    /// last, so that a folder with that file is complete at every moment, also after a crash. Two
    /// that publish into one folder take turns. When a file cannot be moved, everything that was
    /// there before is put back.
    ///
    /// `replaced` names files that an older set may have and this one need not: where they are not
    /// staged, they go. Call it once. Fails with unwritable_output.
    Status publish(const std::string& last, const std::vector<std::string>& replaced = {});

private:
    StagedFolder(std::filesystem::path folder, std::filesystem::path staging,
                 std::filesystem::path first_made, FileLock alive);

    std::filesystem::path folder_;
    std::filesystem::path staging_;
    std::filesystem::path first_made_;  // the outermost folder that did not exist; "" if all did
    FileLock alive_;                    // tells others that this is no leftover
};

}  // namespace splitsum
