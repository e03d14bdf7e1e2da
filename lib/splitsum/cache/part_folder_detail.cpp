#include "splitsum/cache/part_folder_detail.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <ctime>

#include "splitsum/cache/entry_index_detail.h"

namespace splitsum {
namespace {

constexpr std::string_view hexadecimal = "0123456789abcdef";

// 32 digits that all processes under one kernel agree on, and no others: locks of one kernel are
// seen by those alone. Host names and process ids are not that clear, with containers about.
std::string digits_of_boot() {
    const Descriptor file(open("/proc/sys/kernel/random/boot_id", O_RDONLY | O_CLOEXEC));
    std::string digits = file ? read_all(file, 64) : std::string();
    std::erase_if(digits, [](char letter) { return hexadecimal.find(letter) == hexadecimal.npos; });
    return is_digits(digits) ? digits : std::string(32, '0');
}

std::string random_digits() {
    unsigned char bytes[8] = {};
    if (getrandom(bytes, sizeof bytes, 0) != sizeof bytes) return {};
    std::string digits;
    for (const unsigned char byte : bytes) {
        digits += hexadecimal[byte >> 4];
        digits += hexadecimal[byte & 15];
    }
    return digits;
}

// "BOOT-RANDOM"
bool is_part_name(const std::string& name) {
    return name.size() == 49 && is_digits(name.substr(0, 32)) && name[32] == '-' &&
           name.find_first_not_of(hexadecimal, 33) == name.npos;
}

std::string new_part_name() { return digits_of_boot() + "-" + random_digits(); }

bool is_ours(const Descriptor& folder, const std::string& name) {
    struct stat about {};
    const bool is_numbered = name.size() < 6 && name.find_first_not_of("0123456789") == name.npos;
    return (name == "index" || is_numbered) &&
           fstatat(folder.get(), name.c_str(), &about, AT_SYMLINK_NOFOLLOW) == 0 &&
           S_ISREG(about.st_mode);
}

void remove_part(const Descriptor& parts, const std::string& name) {
    if (const Descriptor folder = open_folder(parts, name))
        for (const std::string& file : names_in(folder))
            if (is_ours(folder, file)) unlinkat(folder.get(), file.c_str(), 0);
    unlinkat(parts.get(), name.c_str(), AT_REMOVEDIR);
}

bool is_abandoned(const Descriptor& part, const std::string& name) {
    if (name.starts_with(digits_of_boot())) {
        if (flock(part.get(), LOCK_EX | LOCK_NB) == 0) return true;
        if (errno == EWOULDBLOCK) return false;
    }
    constexpr time_t day = 24 * 60 * 60;
    struct stat about {};
    return fstat(part.get(), &about) == 0 && time(nullptr) - about.st_mtime > day;
}

}  // namespace

PartFolder PartFolder::make(const Descriptor& root) {
    PartFolder part;
    part.parts_ = make_and_open_folder(root, "parts");
    if (!part.parts_) return part;
    // A sweep between making and locking takes the folder away; more than one would be odd.
    for (int attempt = 0; attempt < 100; ++attempt) {
        part.name_ = new_part_name();
        if (mkdirat(part.parts_.get(), part.name_.c_str(), 0777) != 0) return part;
        Descriptor folder = open_folder(part.parts_, part.name_);
        if (!folder) continue;
        if (flock(folder.get(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) continue;
        if (!is_still(part.parts_, part.name_, folder)) continue;
        part.folder_ = std::move(folder);
        return part;
    }
    errno = EBUSY;
    return part;
}

PartFolder::~PartFolder() {
    if (folder_ && !name_.empty()) remove_part(parts_, name_);
}

bool PartFolder::move_to(const Descriptor& parent, const std::string& name) {
    if (renameat(parts_.get(), name_.c_str(), parent.get(), name.c_str()) != 0) return false;
    name_.clear();
    return true;
}

void discard_entry(const Descriptor& root, const Descriptor& shelf, const std::string& key) {
    const Descriptor parts = make_and_open_folder(root, "parts");
    if (!parts) return;
    const std::string name = new_part_name();
    if (renameat(shelf.get(), key.c_str(), parts.get(), name.c_str()) == 0)
        remove_part(parts, name);
}

void sweep_parts(const Descriptor& root) {
    const Descriptor parts = open_folder(root, "parts");
    if (!parts) return;
    for (const std::string& name : names_in(parts)) {
        if (!is_part_name(name)) continue;
        const Descriptor part = open_folder(parts, name);
        if (part && is_abandoned(part, name)) remove_part(parts, name);
    }
}

}  // namespace splitsum
