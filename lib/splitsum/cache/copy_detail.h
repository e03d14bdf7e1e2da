#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "splitsum/cache/descriptor_detail.h"

namespace splitsum {

/// On which side a copy failed, and why (a value of errno).
struct CopyFailure {
    bool reading;
    int reason;
};

/// Appends what is left of `from` to `to`, inside the kernel where it can: a file system that
/// shares blocks between files then copies nothing.
std::optional<CopyFailure> copy_bytes(const Descriptor& from, const Descriptor& to);

/// Length and XXH3-128 digits of a whole file.
struct FileSum {
    int64_t bytes = 0;
    std::string hash;

    bool operator==(const FileSum&) const = default;
};

/// Reads the file once; nothing, with errno, where it cannot.
std::optional<FileSum> sum_of(const Descriptor& file);

}  // namespace splitsum
