#pragma once

#include <filesystem>
#include <optional>

#include "splitsum/base/result.h"

namespace splitsum {

/// A file that nobody else may lock while this lives: neither another process, on this machine or
/// on another that shares the folder, nor another thread. The system lets go of it when its process
/// dies, however it dies.
///
/// The lock is advisory (flock). Where a file system has no locks, waiting for one succeeds at once
/// and trying never does: what must be kept apart is then kept apart by its name alone.
class FileLock {
public:
    /// Makes the file if it is missing, and waits until nobody holds it. Fails with
    /// unwritable_output.
    static Result<FileLock> wait_for(const std::filesystem::path& file);

    /// The same without waiting; nothing where somebody holds it.
    static Result<std::optional<FileLock>> try_now(const std::filesystem::path& file);

    FileLock(FileLock&& other) noexcept;
    FileLock& operator=(FileLock&&) = delete;
    /// Lets go of it. The file stays.
    ~FileLock();

    /// Removes the file, which is safe while it is held: those who wait for it make a new one.
    void remove_file() const;

private:
    FileLock(std::filesystem::path file, int descriptor);

    std::filesystem::path file_;
    int descriptor_;
};

}  // namespace splitsum
