#include "splitsum/base/staged_folder.h"

#include <unistd.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "splitsum/base/atomic_file.h"
#include "splitsum/base/text.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

// The outermost part of the path that does not exist yet, "" if all of it does.
fs::path outermost_missing(const fs::path& folder) {
    std::error_code failure;
    fs::path missing;
    for (fs::path part = fs::absolute(folder, failure).lexically_normal();
         !part.empty() && !fs::exists(part, failure) && part != part.parent_path();
         part = part.parent_path())
        missing = part;
    return missing;
}

}  // namespace

Result<StagedFolder> StagedFolder::create(const fs::path& folder) {
    StagedFolder staged(folder, outermost_missing(folder));
    if (const Status made = make_folder(folder); !made) return made.error();
    if (const Status made = make_folder(staged.staging_); !made) return made.error();
    return staged;
}

StagedFolder::StagedFolder(fs::path folder, fs::path first_made)
    : folder_(std::move(folder)),
      staging_(folder_ / cat(".", getpid(), ".part")),
      first_made_(std::move(first_made)) {}

StagedFolder::StagedFolder(StagedFolder&& other) noexcept
    : folder_(std::move(other.folder_)),
      staging_(std::exchange(other.staging_, {})),
      first_made_(std::exchange(other.first_made_, {})) {}

StagedFolder::~StagedFolder() {
    std::error_code failure;
    if (!staging_.empty()) fs::remove_all(staging_, failure);
    if (first_made_.empty()) return;
    // Only while they are empty: somebody else may have put something there meanwhile.
    fs::path folder = fs::absolute(folder_, failure).lexically_normal();
    while (fs::remove(folder, failure) && folder != first_made_) folder = folder.parent_path();
}

Status StagedFolder::publish() {
    std::error_code failure;
    std::vector<fs::path> names;
    for (const auto& entry : fs::directory_iterator(staging_, failure))
        names.push_back(entry.path().filename());
    std::ranges::sort(names);
    for (const fs::path& name : names) {
        if (const Status possible = check_writable(folder_ / name); !possible) return possible;
        fs::rename(staging_ / name, folder_ / name, failure);
        if (failure)
            return Error{ErrorKind::unwritable_output,
                         cat("cannot write ", (folder_ / name).string(), ": ", failure.message())};
    }
    first_made_.clear();
    return ok;
}

}  // namespace splitsum
