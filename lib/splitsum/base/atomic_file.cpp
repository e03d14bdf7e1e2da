#include "splitsum/base/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "splitsum/base/file_lock.h"
#include "splitsum/base/temporary.h"
#include "splitsum/base/text.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

Error unwritable(const fs::path& path, const std::string& reason) {
    return {ErrorKind::unwritable_output, cat("cannot write ", path.string(), ": ", reason)};
}

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

Status write_all(const fs::path& file, const std::byte* data, size_t size) {
    const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor < 0) return unwritable(file, std::strerror(errno));
    int failure = 0;
    while (size > 0 && failure == 0) {
        const ssize_t written = ::write(descriptor, data, size);
        if (written < 0 && errno != EINTR) failure = errno;
        if (written > 0) {
            data += written;
            size -= static_cast<size_t>(written);
        }
    }
    if (close(descriptor) != 0 && failure == 0) failure = errno;
    if (failure != 0) return unwritable(file, std::strerror(failure));
    return ok;
}

}  // namespace

Status check_writable(const fs::path& path) {
    std::error_code failure;
    if (fs::exists(path, failure) && !fs::is_regular_file(path, failure))
        return unwritable(path, "it exists and is not a regular file");
    const fs::path folder = folder_of(path);
    if (!fs::is_directory(folder, failure))
        return unwritable(path, cat("the folder ", folder.string(), " does not exist"));
    if (access(folder.c_str(), W_OK) != 0)
        return unwritable(path, cat("the folder ", folder.string(), ": ", std::strerror(errno)));
    return ok;
}

Status flush_to_disk(const fs::path& file_or_folder) {
    const int descriptor = open(file_or_folder.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) return unwritable(file_or_folder, std::strerror(errno));
    const int failure = fsync(descriptor) != 0 ? errno : 0;
    close(descriptor);
    // EINVAL: the file system does this for files only.
    if (failure != 0 && failure != EINVAL)
        return unwritable(file_or_folder, std::strerror(failure));
    return ok;
}

Status write_file_whole(const fs::path& path,
                        const std::function<Status(const fs::path& temporary)>& write,
                        Durability durability) {
    if (const Status possible = check_writable(path); !possible) return possible;
    std::error_code failure;
    // Renaming over a link would replace the link, not what it points to.
    const fs::path target =
        fs::is_symlink(path, failure) ? fs::weakly_canonical(path, failure) : path;
    remove_leftovers(folder_of(target));
    const fs::path temporary = folder_of(target) / temporary_name();
    const auto alive = FileLock::wait_for(temporary);
    if (!alive) return alive.error();
    Status status = write(temporary);
    if (status && durability == Durability::flushed) status = flush_to_disk(temporary);
    if (status) {
        fs::rename(temporary, target, failure);
        if (failure) status = unwritable(path, failure.message());
    }
    if (!status) fs::remove(temporary, failure);
    return status;
}

Status write_bytes_whole(const fs::path& path, std::span<const std::byte> bytes,
                         Durability durability) {
    const auto write = [&](const fs::path& temporary) {
        return write_all(temporary, bytes.data(), bytes.size());
    };
    return write_file_whole(path, write, durability);
}

Status write_text_whole(const fs::path& path, std::string_view text, Durability durability) {
    return write_bytes_whole(path, std::as_bytes(std::span(text.data(), text.size())), durability);
}

Status make_folder(const fs::path& folder) {
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (failure) return unwritable(folder, failure.message());
    return ok;
}

}  // namespace splitsum
