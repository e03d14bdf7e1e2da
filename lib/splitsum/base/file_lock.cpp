#include "splitsum/base/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "splitsum/base/text.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

// Whoever held the file before may have removed or renamed it: the lock would then be of a file
// that nobody else can find.
bool is_still_there(const fs::path& file, int descriptor) {
    struct stat by_name {};
    struct stat by_descriptor {};
    return lstat(file.c_str(), &by_name) == 0 && fstat(descriptor, &by_descriptor) == 0 &&
           by_name.st_ino == by_descriptor.st_ino && by_name.st_dev == by_descriptor.st_dev;
}

enum class Attempt { locked, held_by_another, without_locks };

Attempt lock(int descriptor, int operation) {
    int result = 0;
    do result = flock(descriptor, operation);
    while (result != 0 && errno == EINTR);
    if (result == 0) return Attempt::locked;
    return errno == EWOULDBLOCK ? Attempt::held_by_another : Attempt::without_locks;
}

struct Locked {
    int descriptor;
    Attempt attempt;
};

Result<Locked> open_and_lock(const fs::path& file, int operation) {
    for (;;) {
        const int descriptor =
            open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
        if (descriptor < 0)
            return Error{ErrorKind::unwritable_output,
                         cat("cannot write ", file.string(), ": ", std::strerror(errno))};
        const Attempt attempt = lock(descriptor, operation);
        if (attempt != Attempt::locked || is_still_there(file, descriptor))
            return Locked{descriptor, attempt};
        close(descriptor);
    }
}

}  // namespace

Result<FileLock> FileLock::wait_for(const fs::path& file) {
    const auto locked = open_and_lock(file, LOCK_EX);
    if (!locked) return locked.error();
    return FileLock(file, locked->descriptor);
}

Result<std::optional<FileLock>> FileLock::try_now(const fs::path& file) {
    const auto locked = open_and_lock(file, LOCK_EX | LOCK_NB);
    if (!locked) return locked.error();
    FileLock lock(file, locked->descriptor);
    if (locked->attempt != Attempt::locked) return std::optional<FileLock>();
    return std::optional<FileLock>(std::move(lock));
}

FileLock::FileLock(fs::path file, int descriptor)
    : file_(std::move(file)), descriptor_(descriptor) {}

FileLock::FileLock(FileLock&& other) noexcept
    : file_(std::move(other.file_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

FileLock::~FileLock() {
    if (descriptor_ >= 0) close(descriptor_);
}

void FileLock::remove_file() const {
    std::error_code ignored;
    fs::remove(file_, ignored);
}

}  // namespace splitsum
