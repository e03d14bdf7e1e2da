#include "splitsum/cache/content_cache.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <mutex>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "splitsum/base/text.h"
#include "splitsum/cache/cache_folder_detail.h"
#include "splitsum/cache/entry_detail.h"
#include "splitsum/cache/eviction_detail.h"
#include "splitsum/cache/part_folder_detail.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

constexpr size_t most_files = 1000;

Error bad_argument(const std::string& message) { return {ErrorKind::bad_argument, message}; }

Result<std::string> digits_of(const std::string& key) {
    constexpr std::string_view prefix = "xxh3-128:";
    std::string digits = key.starts_with(prefix) ? key.substr(prefix.size()) : key;
    if (is_digits(digits)) return digits;
    return bad_argument(cat("'", key, "' is not a key of a cache: 32 hexadecimal digits are"));
}

// In order and each once, so that equal folders make equal entries.
Result<std::vector<std::string>> checked(std::span<const std::string> names) {
    if (names.empty() || names.size() > most_files)
        return bad_argument(
            cat("a cache keeps 1 to ", most_files, " files under a key, not ", names.size()));
    for (const std::string& name : names)
        if (!is_file_name(name))
            return bad_argument(cat("'", name, "' is not the name of a file that a cache keeps"));
    std::vector<std::string> sorted(names.begin(), names.end());
    std::ranges::sort(sorted);
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    return sorted;
}

int64_t size_of(const fs::path& folder, const std::vector<std::string>& names) {
    int64_t sum = 0;
    for (const std::string& name : names) {
        struct stat about {};
        if (lstat((folder / name).c_str(), &about) == 0) sum += about.st_size;
    }
    return sum;
}

bool is_for_lack_of_permission(int reason) {
    return reason == EACCES || reason == EPERM || reason == EROFS;
}

}  // namespace

struct ContentCache::State {
    fs::path folder;
    int64_t most_bytes;
    Descriptor root;
    std::atomic<bool> said_unwritable = false;

    std::mutex counting;
    std::optional<int64_t> bytes_at_walk;  // nothing before the first
    int64_t stored_since = 0;

    Status not_writable(int reason);
    void count(int64_t bytes);
    void walk();
};

// A read-only cache is worth one message, not one a panorama.
Status ContentCache::State::not_writable(int reason) {
    if (is_for_lack_of_permission(reason) && said_unwritable.exchange(true)) return ok;
    return Error{ErrorKind::unwritable_output,
                 cat("cannot write to the cache ", folder.string(), ": ", std::strerror(reason))};
}

// Other processes store too: a sixteenth of the limit after the last walk it is time for another.
void ContentCache::State::count(int64_t bytes) {
    const std::lock_guard guard(counting);
    stored_since += bytes;
    if (!bytes_at_walk || stored_since > most_bytes / 16 ||
        *bytes_at_walk > most_bytes - stored_since)
        walk();
}

void ContentCache::State::walk() {
    const Descriptor lock(
        openat(root.get(), "lock", O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666));
    // Several may evict at once; it is only a waste.
    if (lock && flock(lock.get(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) return;
    sweep_parts(root);
    bytes_at_walk = evict(root, most_bytes);
    stored_since = 0;
}

ContentCache::ContentCache(std::unique_ptr<State> state) : state_(std::move(state)) {}
ContentCache::ContentCache(ContentCache&&) noexcept = default;
ContentCache& ContentCache::operator=(ContentCache&&) noexcept = default;
ContentCache::~ContentCache() = default;

Result<ContentCache> ContentCache::open(const fs::path& folder, int64_t most_bytes) {
    if (most_bytes < 0)
        return bad_argument(cat("a cache cannot be limited to ", most_bytes, " bytes"));
    auto root = open_cache_folder(folder);
    if (!root) return root.error();
    auto state = std::make_unique<State>();
    state->folder = folder;
    state->most_bytes = most_bytes;
    state->root = std::move(*root);
    return ContentCache(std::move(state));
}

Result<bool> ContentCache::fetch(const std::string& key, const fs::path& into_folder) const {
    const auto digits = digits_of(key);
    if (!digits) return digits.error();
    const Descriptor shelf = open_shelf(state_->root, *digits);
    const Descriptor entry = shelf ? open_folder(shelf, *digits) : Descriptor();
    if (!entry) return false;
    const FoundIndex index = read_index(entry, *digits);
    Found found = index.found;
    if (found == Found::whole) {
        const auto fetched = fetch_files(entry, index.index, into_folder);
        if (!fetched) return fetched.error();
        found = *fetched;
    }
    if (found == Found::whole) mark_used(entry);
    // An entry that was moved away meanwhile looks damaged too, and another may be in its place.
    if (found == Found::damaged && is_still(shelf, *digits, entry))
        discard_entry(state_->root, shelf, *digits);
    return found == Found::whole;
}

Status ContentCache::store(const std::string& key, const fs::path& from_folder,
                           std::span<const std::string> names) const {
    const auto digits = digits_of(key);
    if (!digits) return digits.error();
    const auto files = checked(names);
    if (!files) return files.error();
    if (size_of(from_folder, *files) > state_->most_bytes) return state_->count(0), ok;

    const Descriptor shelf = make_and_open_shelf(state_->root, *digits);
    if (!shelf) return state_->not_writable(errno);
    if (const Descriptor there = open_folder(shelf, *digits)) return mark_used(there), ok;
    PartFolder part = PartFolder::make(state_->root);
    if (!part) return state_->not_writable(errno);
    const auto index = fill_entry(part.folder(), *digits, from_folder, *files, state_->folder);
    if (!index) return index.error();
    if (!part.move_to(shelf, *digits)) {
        // Whoever was faster stored the same.
        if (errno == EEXIST || errno == ENOTEMPTY) return ok;
        return state_->not_writable(errno);
    }
    state_->count(index->bytes());
    return ok;
}

Status ContentCache::store(const std::string& key, const fs::path& from_folder) const {
    std::vector<std::string> names;
    std::error_code failure;
    for (auto file = fs::directory_iterator(from_folder, failure);
         !failure && file != fs::directory_iterator(); file.increment(failure))
        if (file->symlink_status(failure).type() == fs::file_type::regular &&
            !file->path().filename().native().starts_with('.'))
            names.push_back(file->path().filename());
    if (failure)
        return Error{ErrorKind::unreadable_input,
                     cat("cannot read ", from_folder.string(), ": ", failure.message())};
    return store(key, from_folder, names);
}

}  // namespace splitsum
