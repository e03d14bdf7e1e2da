#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "splitsum/base/result.h"
#include "splitsum/manifest/known_option.h"
#include "splitsum/manifest/setting.h"

namespace splitsum {

/// One panorama, or a folder of them, and how to bake it.
struct ManifestPanorama {
    std::filesystem::path file;  ///< a file or a folder; relative to the working directory
    /// Its folder below the output folder, '/'-separated: no part is empty or begins with a dot. If
    /// not given, that of a panorama on the command line.
    std::optional<std::string> name;
    std::vector<std::string> only;    ///< patterns for the files of a folder; empty: all of them
    std::vector<std::string> except;  ///< patterns for files that are left out
    std::vector<Setting> settings;    ///< defaults included, one an option, in the order of names
    std::filesystem::path manifest;   ///< which names it, and the line, from 1
    int line = 0;
};

/// "bake.toml:12".
std::string place_of(const ManifestPanorama& panorama);

/// What a manifest and all that it includes say.
struct Manifest {
    std::vector<Setting> run;  ///< options of the whole run, one an option, in the order of names
    std::vector<ManifestPanorama> panoramas;   ///< at least one; the included ones first
    std::vector<std::filesystem::path> files;  ///< every manifest read, this one first
};

/// Reads a manifest in TOML (.toml) or JSON (.json), and those that it includes; README.md has the
/// format. `options` are those that it may name. The panoramas need not exist; whether they are
/// folders is looked up.
///
/// The message of an Error has a line of its own for each of up to ten problems, each as
/// "file:line: what was found, what would work". Fails with unreadable_input (absent, not UTF-8,
/// over 16 MiB, nested too deeply, bad syntax) and bad_argument: unknown keys, wrong types,
/// manifests that include each other in a circle or are included twice, two panoramas of one name,
/// a manifest without panoramas.
///
/// Cost: about 15 us a panorama.
Result<Manifest> read_manifest(const std::filesystem::path& path,
                               std::span<const KnownOption> options);

}  // namespace splitsum
