#include "splitsum/base/temporary.h"

#include <cstdint>
#include <random>
#include <string_view>
#include <vector>

#include "splitsum/base/file_lock.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view prefix = ".splitsum-";
constexpr std::string_view suffix = ".part";
constexpr size_t digit_count = 16;

void remove_file_left_over(const fs::path& file) {
    const auto lock = FileLock::try_now(file);
    if (lock && *lock) (*lock)->remove_file();
}

// Renamed first: whoever has just made the folder and waits for its lock then finds it gone, and
// makes another, instead of locking a file in a folder that is being removed.
void remove_folder_left_over(const fs::path& folder) {
    const auto lock = FileLock::try_now(folder / lock_of_temporary);
    if (!lock || !*lock) return;
    std::error_code failure;
    const fs::path renamed = folder.parent_path() / temporary_name();
    fs::rename(folder, renamed, failure);
    if (!failure) fs::remove_all(renamed, failure);
}

}  // namespace

std::string temporary_name() {
    std::random_device random;
    std::string name(prefix);
    for (size_t i = 0; i < digit_count; i += 8) {
        const uint32_t bits = random();
        for (int shift = 28; shift >= 0; shift -= 4)
            name += "0123456789abcdef"[(bits >> shift) & 15];
    }
    return name.append(suffix);
}

bool is_temporary_name(const std::string& name) {
    if (name.size() != prefix.size() + digit_count + suffix.size()) return false;
    if (!name.starts_with(prefix) || !name.ends_with(suffix)) return false;
    return name.find_first_not_of("0123456789abcdef", prefix.size()) == prefix.size() + digit_count;
}

void remove_leftovers(const fs::path& folder) {
    std::error_code failure;
    std::vector<fs::directory_entry> found;
    for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end;
         entry.increment(failure))
        if (is_temporary_name(entry->path().filename().string())) found.push_back(*entry);
    for (const fs::directory_entry& entry : found) {
        const fs::file_type type = entry.symlink_status(failure).type();
        if (type == fs::file_type::directory) remove_folder_left_over(entry.path());
        if (type == fs::file_type::regular) remove_file_left_over(entry.path());
    }
}

}  // namespace splitsum
