#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "splitsum/base/result.h"

namespace splitsum {

/// A panorama of a library.
struct ListedPanorama {
    std::filesystem::path file;
    /// The folder of its results below the output folder, '/'-separated: "dusk/venice".
    std::string name;
};

/// What to take from folders. Files that are named themselves are always taken.
///
/// A pattern is that of a shell: `*` any characters, `?` one, `[a-c]` one of these. Without a '/' it
/// is compared with the name of a file, with one with the path below the folder that was given,
/// where `*` also stands for '/': "dusk/*" is everything below dusk.
struct ListOptions {
    /// Files to take; if empty, everything with an ending of panorama_endings, in any letter case.
    std::vector<std::string> include;
    /// Files not to take, and folders not to search.
    std::vector<std::string> exclude;
    std::filesystem::path output;  ///< a folder that is never searched; "" for none
};

/// What panoramas are stored as: "hdr", "exr", ...
std::span<const char* const> panorama_endings();

/// The panoramas of files and folders, in the order of `inputs` and below a folder in that of their
/// names. A file is named by its stem; one found in a folder by its path below that folder, without
/// the ending. Entries that begin with a dot are skipped; links are followed, but not in circles.
///
/// A file that is missing is listed all the same: it fails when it is read, and costs the others
/// nothing. Fails with bad_argument (a pattern in `include` that matches nothing, the output folder
/// as an input), unusable_input (a folder without panoramas) and unreadable_input (a folder that
/// cannot be read).
Result<std::vector<ListedPanorama>> list_panoramas(const std::vector<std::filesystem::path>& inputs,
                                                   const ListOptions& options);

/// Whether the results of all of these can lie in one folder: every name is a plain relative path,
/// no two are the same, also where upper and lower case of a to z do not differ, as on other
/// systems' disks, and no results lie where another's file or brdf.ktx2 must be. Fails with
/// bad_argument, naming both.
Status check_names(std::span<const ListedPanorama> panoramas);

}  // namespace splitsum
