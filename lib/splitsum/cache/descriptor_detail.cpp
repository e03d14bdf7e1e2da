#include "splitsum/cache/descriptor_detail.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <memory>

namespace splitsum {
namespace {

struct CloseFolder {
    void operator()(DIR* folder) const { closedir(folder); }
};

}  // namespace

Descriptor::~Descriptor() {
    const int reason = errno;  // that of the failure which ends the scope
    if (descriptor_ >= 0) close(descriptor_);
    errno = reason;
}

Descriptor open_folder(const Descriptor& parent, const std::string& name) {
    return Descriptor(
        openat(parent.get(), name.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
}

Descriptor make_and_open_folder(const Descriptor& parent, const std::string& name) {
    Descriptor folder = open_folder(parent, name);
    if (folder || errno != ENOENT) return folder;
    if (mkdirat(parent.get(), name.c_str(), 0777) != 0 && errno != EEXIST) return Descriptor();
    return open_folder(parent, name);
}

Descriptor open_file(const Descriptor& parent, const std::string& name) {
    // Without O_NONBLOCK a pipe of that name would wait for a writer.
    Descriptor file(
        openat(parent.get(), name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    struct stat about {};
    if (!file || fstat(file.get(), &about) != 0) return Descriptor();
    if (S_ISREG(about.st_mode)) return file;
    errno = EINVAL;
    return Descriptor();
}

Descriptor create_file(const Descriptor& parent, const std::string& name) {
    return Descriptor(openat(parent.get(), name.c_str(),
                             O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
}

std::vector<std::string> names_in(const Descriptor& folder) {
    std::vector<std::string> names;
    const int again = openat(folder.get(), ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (again < 0) return names;
    const std::unique_ptr<DIR, CloseFolder> listing(fdopendir(again));
    if (!listing) {
        close(again);
        return names;
    }
    while (const dirent* entry = readdir(listing.get())) {
        const std::string_view name = entry->d_name;
        if (name != "." && name != "..") names.emplace_back(name);
    }
    return names;
}

bool is_still(const Descriptor& parent, const std::string& name, const Descriptor& open) {
    struct stat named {
    }, opened{};
    return fstatat(parent.get(), name.c_str(), &named, AT_SYMLINK_NOFOLLOW) == 0 &&
           fstat(open.get(), &opened) == 0 && named.st_dev == opened.st_dev &&
           named.st_ino == opened.st_ino;
}

bool write_all(const Descriptor& file, std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = write(file.get(), text.data(), text.size());
        if (written < 0 && errno != EINTR) return false;
        if (written > 0) text.remove_prefix(static_cast<size_t>(written));
    }
    return true;
}

std::string read_all(const Descriptor& file, size_t most) {
    struct stat about {};
    if (fstat(file.get(), &about) != 0 || about.st_size > static_cast<off_t>(most)) return {};
    // Files of /proc say that they are empty.
    std::string text(about.st_size > 0 ? static_cast<size_t>(about.st_size) : most, '\0');
    size_t size = 0;
    while (size < text.size()) {
        const ssize_t count = read(file.get(), text.data() + size, text.size() - size);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return {};
        if (count == 0) break;
        size += static_cast<size_t>(count);
    }
    text.resize(size);
    return text;
}

}  // namespace splitsum
