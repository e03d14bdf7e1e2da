#pragma once

#include <filesystem>
#include <string>

namespace splitsum {

/// A name for a file or folder that is on its way: ".splitsum-", 16 digits, ".part". No other
/// thread, process or machine comes up with the same.
std::string temporary_name();

/// Whether a name is one of those.
bool is_temporary_name(const std::string& name);

/// Inside a temporary folder: the file that whoever fills the folder keeps locked (FileLock). A
/// temporary file is locked itself.
inline constexpr const char* lock_of_temporary = ".lock";

/// Removes the temporary files and folders in `folder` whose makers are no more, and leaves those
/// of the living. What cannot be removed stays. Cost: reads the folder.
void remove_leftovers(const std::filesystem::path& folder);

}  // namespace splitsum
