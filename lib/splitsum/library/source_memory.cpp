#include "splitsum/library/source_memory.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>

#include "splitsum/base/atomic_file.h"
#include "splitsum/base/content_hash.h"
#include "splitsum/base/file_hash.h"
#include "splitsum/base/text.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

constexpr const char* note_name = ".source";
constexpr const char* note_version = "splitsum-source-1";

// The coarsest clock of a file system that is in use, FAT's, counts in 2 s. It also covers machines
// whose clocks differ a little.
constexpr int64_t clearly_older_ns = 3'000'000'000;

int64_t nanoseconds(const timespec& time) {
    return int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

int64_t now_ns() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
               std::chrono::system_clock::now().time_since_epoch())
        .count();
}

bool is_same_file(const SourceStamp& a, const SourceStamp& b) {
    return a.bytes == b.bytes && a.modified_ns == b.modified_ns && a.changed_ns == b.changed_ns &&
           a.inode == b.inode;
}

bool may_change_unseen(const SourceStamp& stamp) {
    return std::max(stamp.modified_ns, stamp.changed_ns) + clearly_older_ns > stamp.asked_ns;
}

struct Note {
    SourceStamp stamp;
    std::string hash;
};

std::optional<Note> read_note(const fs::path& folder) {
    std::ifstream file(folder / note_name);
    std::string version, end;
    Note note;
    SourceStamp& stamp = note.stamp;
    file >> version >> stamp.bytes >> stamp.modified_ns >> stamp.changed_ns >> stamp.inode >>
        stamp.asked_ns >> note.hash >> end;
    if (!file || version != note_version || end != "end") return std::nullopt;
    return note;
}

}  // namespace

Result<SourceStamp> stamp_of(const fs::path& source) {
    SourceStamp stamp;
    stamp.asked_ns = now_ns();
    struct stat entry {};
    if (stat(source.c_str(), &entry) != 0)
        return Error{ErrorKind::unreadable_input,
                     cat("cannot read ", source.string(), ": ", std::strerror(errno))};
    stamp.bytes = entry.st_size;
    stamp.modified_ns = nanoseconds(entry.st_mtim);
    stamp.changed_ns = nanoseconds(entry.st_ctim);
    stamp.inode = entry.st_ino;
    return stamp;
}

Status check_unchanged(const fs::path& source, const SourceStamp& before) {
    const auto now = stamp_of(source);
    if (!now) return now.error();
    if (is_same_file(*now, before)) return ok;
    return Error{ErrorKind::unreadable_input,
                 cat(source.string(),
                     " changed while it was read; bake it again when it is "
                     "complete")};
}

Status remember_source(const fs::path& folder, const SourceStamp& stamp, const std::string& hash) {
    return write_text_whole(
        folder / note_name,
        cat(note_version, ' ', stamp.bytes, ' ', stamp.modified_ns, ' ', stamp.changed_ns, ' ',
            stamp.inode, ' ', stamp.asked_ns, ' ', hash, " end\n"),
        Durability::unflushed);
}

Result<SourceHash> hash_of_source(const fs::path& source, const fs::path& folder) {
    const auto stamp = stamp_of(source);
    if (!stamp) return stamp.error();
    const auto note = read_note(folder);
    if (note && is_same_file(note->stamp, *stamp) && !may_change_unseen(note->stamp))
        return SourceHash{note->hash, note->stamp, false};
    const auto hash = hash_of_file(source);
    if (!hash) return hash.error();
    if (Status unchanged = check_unchanged(source, *stamp); !unchanged) return unchanged.error();
    return SourceHash{named_hash(*hash), *stamp, true};
}

}  // namespace splitsum
