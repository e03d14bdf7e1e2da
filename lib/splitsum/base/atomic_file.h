#pragma once

#include <filesystem>
#include <functional>
#include <span>

#include "splitsum/base/result.h"

namespace splitsum {

/// Whether a file could be written to `path` as far as can be told without doing it: the folder is
/// there and may be written to, and what has that name now is a regular file or nothing. Asked
/// before long work. Fails with unwritable_output.
Status check_writable(const std::filesystem::path& path);

/// Whether a file must outlast a crash of the machine, which costs a wait for the disk. After a
/// crash, a file that need not may be empty.
enum class Durability { flushed, unflushed };

/// Calls write(temporary) with an empty file in the folder of `path`, which it opens and fills, makes
/// what was written durable, and renames it to `path`: the file appears complete or not at all, and
/// an older file of that name survives every failure. The temporary is removed when anything fails;
/// those of killed processes are removed first (base/temporary.h).
///
/// Fails with unwritable_output (the folder is missing, not writable, full, ...) or with the error
/// that `write` returned.
Status write_file_whole(const std::filesystem::path& path,
                        const std::function<Status(const std::filesystem::path& temporary)>& write,
                        Durability durability = Durability::flushed);

/// Writes `bytes` to `path`, whole or not at all.
Status write_bytes_whole(const std::filesystem::path& path, std::span<const std::byte> bytes,
                         Durability durability = Durability::flushed);

/// Writes `text` to `path`, whole or not at all.
Status write_text_whole(const std::filesystem::path& path, std::string_view text,
                        Durability durability = Durability::flushed);

/// Waits until a file, or the names in a folder, are on the disk. Fails with unwritable_output.
Status flush_to_disk(const std::filesystem::path& file_or_folder);

/// Makes sure that `folder` exists, creating it and its parents. Fails with unwritable_output.
Status make_folder(const std::filesystem::path& folder);

}  // namespace splitsum
