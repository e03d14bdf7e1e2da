#include "splitsum/cache/entry_detail.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "splitsum/base/text.h"
#include "splitsum/cache/copy_detail.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

constexpr size_t longest_index = size_t(1) << 20;

Error unwritable(const fs::path& path, int reason) {
    return {ErrorKind::unwritable_output,
            cat("cannot write ", path.string(), ": ", std::strerror(reason))};
}

Error unreadable(const fs::path& path, int reason) {
    return {ErrorKind::unreadable_input,
            cat("cannot read ", path.string(), ": ", std::strerror(reason))};
}

// A file that is missing, or is a link or a folder, will not become one by waiting.
Found found_after(int reason) {
    return reason == ENOENT || reason == ELOOP || reason == EINVAL ? Found::damaged
                                                                   : Found::unreachable;
}

Descriptor open_by_path(const fs::path& folder) {
    return Descriptor(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
}

// Files that are removed again unless all of them turn out well.
class NewFiles {
public:
    explicit NewFiles(const Descriptor& folder) : folder_(folder) {}
    ~NewFiles() {
        for (const std::string& name : names_) unlinkat(folder_.get(), name.c_str(), 0);
    }
    NewFiles(const NewFiles&) = delete;
    NewFiles& operator=(const NewFiles&) = delete;

    Descriptor create(const std::string& name) {
        Descriptor file = create_file(folder_, name);
        if (file) names_.push_back(name);
        return file;
    }
    void keep() { names_.clear(); }

private:
    const Descriptor& folder_;
    std::vector<std::string> names_;
};

bool has_size(const Descriptor& file, int64_t bytes) {
    struct stat about {};
    return fstat(file.get(), &about) == 0 && about.st_size == bytes;
}

Result<Found> fetch_file(const Descriptor& from, const FileSum& expected, const Descriptor& to,
                         const fs::path& path) {
    if (!has_size(from, expected.bytes)) return Found::damaged;
    if (const auto failure = copy_bytes(from, to)) {
        if (failure->reading) return Found::unreachable;
        return unwritable(path, failure->reason);
    }
    const auto sum = sum_of(to);
    if (!sum) return unwritable(path, errno);
    if (*sum != expected) return Found::damaged;
    if (fsync(to.get()) != 0) return unwritable(path, errno);
    return Found::whole;
}

// One file of a folder that is being stored, checked against what it was when it began.
Result<FileSum> fill_file(const Descriptor& folder, const fs::path& path, const Descriptor& to,
                          const fs::path& cache) {
    const Descriptor from = open_file(folder, path.filename());
    if (!from) return unreadable(path, errno);
    // Of the source and not of the copy, so that fetching notices a copy that went wrong.
    const auto sum = sum_of(from);
    if (!sum) return unreadable(path, errno);
    if (const auto failure = copy_bytes(from, to))
        return failure->reading ? unreadable(path, failure->reason)
                                : unwritable(cache, failure->reason);
    if (!has_size(to, sum->bytes))
        return Error{ErrorKind::unreadable_input,
                     cat("cannot read ", path.string(), ": it is being changed")};
    if (fsync(to.get()) != 0) return unwritable(cache, errno);
    return *sum;
}

struct FileState {
    ino_t inode;
    off_t bytes;
    timespec modified, changed;

    bool operator==(const FileState& other) const {
        const auto equal = [](const timespec& a, const timespec& b) {
            return a.tv_sec == b.tv_sec && a.tv_nsec == b.tv_nsec;
        };
        return inode == other.inode && bytes == other.bytes && equal(modified, other.modified) &&
               equal(changed, other.changed);
    }
};

std::vector<FileState> states_of(const Descriptor& folder, std::span<const std::string> names) {
    std::vector<FileState> states;
    for (const std::string& name : names) {
        struct stat about {};
        if (fstatat(folder.get(), name.c_str(), &about, AT_SYMLINK_NOFOLLOW) != 0) about = {};
        states.push_back({about.st_ino, about.st_size, about.st_mtim, about.st_ctim});
    }
    return states;
}

Status write_index(const Descriptor& entry, const EntryIndex& index, const fs::path& cache) {
    const Descriptor file = create_file(entry, "index");
    if (!file || !write_all(file, text_of(index)) || fsync(file.get()) != 0 ||
        fsync(entry.get()) != 0)
        return unwritable(cache, errno);
    return ok;
}

}  // namespace

Descriptor open_shelf(const Descriptor& root, const std::string& key) {
    const Descriptor entries = open_folder(root, "entries");
    return entries ? open_folder(entries, key.substr(0, 2)) : Descriptor();
}

Descriptor make_and_open_shelf(const Descriptor& root, const std::string& key) {
    const Descriptor entries = make_and_open_folder(root, "entries");
    return entries ? make_and_open_folder(entries, key.substr(0, 2)) : Descriptor();
}

FoundIndex read_index(const Descriptor& entry, const std::string& key) {
    const Descriptor file = open_file(entry, "index");
    if (!file) return {found_after(errno), {}};
    auto index = parse_index(read_all(file, longest_index));
    if (!index || index->key != key) return {Found::damaged, {}};
    return {Found::whole, std::move(*index)};
}

Result<Found> fetch_files(const Descriptor& entry, const EntryIndex& index,
                          const fs::path& folder) {
    const Descriptor into = open_by_path(folder);
    if (!into) return unwritable(folder, errno);
    NewFiles files(into);
    for (size_t i = 0; i < index.files.size(); ++i) {
        const auto& [name, sum] = index.files[i];
        const Descriptor from = open_file(entry, std::to_string(i));
        if (!from) return found_after(errno);
        const Descriptor to = files.create(name);
        if (!to) return unwritable(folder / name, errno);
        const auto found = fetch_file(from, sum, to, folder / name);
        if (!found || *found != Found::whole) return found;
    }
    files.keep();
    return Found::whole;
}

Result<EntryIndex> fill_entry(const Descriptor& entry, const std::string& key, const fs::path& from,
                              std::span<const std::string> names, const fs::path& cache) {
    const Descriptor folder = open_by_path(from);
    if (!folder) return unreadable(from, errno);
    const auto before = states_of(folder, names);
    EntryIndex index{key, {}};
    for (size_t i = 0; i < names.size(); ++i) {
        const Descriptor to = create_file(entry, std::to_string(i));
        if (!to) return unwritable(cache, errno);
        auto sum = fill_file(folder, from / names[i], to, cache);
        if (!sum) return sum.error();
        index.files.push_back({names[i], std::move(*sum)});
    }
    if (states_of(folder, names) != before)
        return Error{ErrorKind::unreadable_input,
                     cat("cannot store ", from.string(), ": its files were changed meanwhile")};
    if (const Status written = write_index(entry, index, cache); !written) return written.error();
    return index;
}

void mark_used(const Descriptor& entry) {
    utimensat(entry.get(), "index", nullptr, AT_SYMLINK_NOFOLLOW);
}

}  // namespace splitsum
