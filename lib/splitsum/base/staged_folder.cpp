#include "splitsum/base/staged_folder.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "splitsum/base/atomic_file.h"
#include "splitsum/base/temporary.h"
#include "splitsum/base/text.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

constexpr const char* older_files = ".older";                            // in the staging folder
constexpr const char* publish_lock = ".splitsum-0000000000000000.part";  // in the target's

Error unwritable(const fs::path& path, const std::error_code& failure) {
    return {ErrorKind::unwritable_output,
            cat("cannot write ", path.string(), ": ", failure.message())};
}

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

// Makes both folders. Another process that has failed may remove the outer one as soon as it is
// there, which is nobody's mistake.
Status make_both(const fs::path& folder, const fs::path& inner) {
    constexpr int most_attempts = 100;
    std::error_code failure;
    for (int attempt = 0; attempt < most_attempts; ++attempt) {
        fs::create_directories(folder, failure);
        if (!failure) fs::create_directory(inner, failure);
        if (!failure) return ok;
        if (failure != std::errc::no_such_file_or_directory &&
            failure != std::errc::not_a_directory)
            break;
    }
    return unwritable(folder, failure);
}

// Only while they are empty: somebody else may have put something there meanwhile.
void remove_again(const fs::path& made, const fs::path& first_made) {
    if (first_made.empty()) return;
    std::error_code failure;
    fs::path folder = fs::absolute(made, failure).lexically_normal();
    while (fs::remove(folder, failure) && folder != first_made) folder = folder.parent_path();
}

std::vector<fs::path> staged_names(const fs::path& staging) {
    std::error_code failure;
    std::vector<fs::path> names;
    for (const auto& entry : fs::directory_iterator(staging, failure))
        if (entry.path().filename() != lock_of_temporary) names.push_back(entry.path().filename());
    std::ranges::sort(names);
    return names;
}

// Moves files, and moves them back again unless everything succeeded.
class Moves {
public:
    Moves(fs::path from, fs::path to) : from_(std::move(from)), to_(std::move(to)) {}
    Moves(const Moves&) = delete;
    ~Moves() {
        std::error_code ignored;
        for (auto move = done_.rbegin(); move != done_.rend(); ++move)
            fs::rename(move->second, move->first, ignored);
    }

    // The file is not there from now on.
    Status take_away(const fs::path& name) {
        std::error_code failure;
        rename(to_ / name, from_ / older_files / name, failure);
        if (failure && failure != std::errc::no_such_file_or_directory)
            return unwritable(to_ / name, failure);
        return ok;
    }

    // The older file, if there is one, is there until the new one is.
    Status replace(const fs::path& name) {
        const fs::path kept = from_ / older_files / name;
        std::error_code failure;
        fs::create_hard_link(to_ / name, kept, failure);
        if (!failure)
            done_.emplace_back(to_ / name, kept);
        else if (const Status away = take_away(name); !away)  // none, or no links on this disk
            return away;
        rename(from_ / name, to_ / name, failure);
        if (failure) return unwritable(to_ / name, failure);
        return ok;
    }

    void keep() { done_.clear(); }

private:
    void rename(const fs::path& from, const fs::path& to, std::error_code& failure) {
        fs::rename(from, to, failure);
        if (!failure) done_.emplace_back(from, to);
    }

    fs::path from_, to_;
    std::vector<std::pair<fs::path, fs::path>> done_;  // from, to
};

Status move_all(const fs::path& staging, const fs::path& folder, const std::vector<fs::path>& names,
                const fs::path& last, const std::vector<std::string>& replaced) {
    Moves moves(staging, folder);
    Status status = moves.take_away(last);
    if (status) status = flush_to_disk(folder);
    for (const fs::path& name : names)
        if (status && name != last) status = moves.replace(name);
    for (const std::string& name : replaced)
        if (status && !std::ranges::count(names, fs::path(name))) status = moves.take_away(name);
    if (status) status = flush_to_disk(folder);
    if (status) status = moves.replace(last);
    if (status) status = flush_to_disk(folder);
    if (status) moves.keep();
    return status;
}

}  // namespace

Result<StagedFolder> StagedFolder::create(const fs::path& folder) {
    const fs::path first_made = outermost_missing(folder);
    remove_leftovers(folder);
    std::error_code failure;
    for (;;) {
        const fs::path staging = folder / temporary_name();
        const Status made = make_both(folder, staging);
        auto alive = made ? FileLock::wait_for(staging / lock_of_temporary) : made.error();
        if (alive) return StagedFolder(folder, staging, first_made, std::move(*alive));
        // Before it was locked, somebody may have taken it for a leftover; then with another name.
        if (made && !fs::exists(staging, failure)) continue;
        fs::remove(staging, failure);
        remove_again(folder, first_made);
        return alive.error();
    }
}

StagedFolder::StagedFolder(fs::path folder, fs::path staging, fs::path first_made, FileLock alive)
    : folder_(std::move(folder)),
      staging_(std::move(staging)),
      first_made_(std::move(first_made)),
      alive_(std::move(alive)) {}

StagedFolder::StagedFolder(StagedFolder&& other) noexcept
    : folder_(std::move(other.folder_)),
      staging_(std::exchange(other.staging_, {})),
      first_made_(std::exchange(other.first_made_, {})),
      alive_(std::move(other.alive_)) {}

StagedFolder::~StagedFolder() {
    std::error_code failure;
    if (!staging_.empty()) fs::remove_all(staging_, failure);
    remove_again(folder_, first_made_);
}

Status StagedFolder::publish(const std::string& last, const std::vector<std::string>& replaced) {
    const std::vector<fs::path> names = staged_names(staging_);
    if (!std::ranges::count(names, fs::path(last)))
        return Error{ErrorKind::internal, cat("'", last, "' should have been written into ",
                                              folder_.string(), " last, and was not")};
    const auto turn = FileLock::wait_for(folder_ / publish_lock);
    if (!turn) return turn.error();
    Status status = make_folder(staging_ / older_files);
    for (const fs::path& name : names)
        if (status) status = check_writable(folder_ / name);
    if (status) status = move_all(staging_, folder_, names, last, replaced);
    turn->remove_file();
    if (status) first_made_.clear();
    return status;
}

}  // namespace splitsum
