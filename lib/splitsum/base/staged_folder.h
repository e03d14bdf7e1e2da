#pragma once

#include <filesystem>
#include <string>

#include "splitsum/base/result.h"

namespace splitsum {

/// A hidden folder inside the one where several files shall appear together: they are written into
/// it, and moved out when all of them are complete. Going out of scope before that removes it, and
/// the folder itself if it was made for this, so that a failure leaves what was there before.
class StagedFolder {
public:
    /// Makes `folder` if it is missing, and the hidden one in it. Fails with unwritable_output.
    static Result<StagedFolder> create(const std::filesystem::path& folder);

    StagedFolder(StagedFolder&& other) noexcept;
    StagedFolder& operator=(StagedFolder&&) = delete;
    ~StagedFolder();

    /// Where to write the files.
    const std::filesystem::path& path() const { return staging_; }

    /// Moves every file to its place, in the order of their names, over older ones. Fails with
    /// unwritable_output.
    Status publish();

private:
    StagedFolder(std::filesystem::path folder, std::filesystem::path first_made);

    std::filesystem::path folder_;
    std::filesystem::path staging_;
    std::filesystem::path first_made_;  // the outermost folder that did not exist; "" if all did
};

}  // namespace splitsum
