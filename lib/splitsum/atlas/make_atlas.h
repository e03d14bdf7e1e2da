#pragma once

#include <filesystem>

#include "splitsum/atlas/atlas.h"
#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"

namespace splitsum {

/// Goes through every case at which methods fail. `scratch` is an empty folder for the files of the
/// cases that are about files. The result depends on the plan alone: not on threads, folders or the
/// time. Reports one step a case. Cost: about half a minute on four cores with the default plan.
///
/// Fails with bad_argument, with unwritable_output where `scratch` cannot be written to, or with
/// interrupted.
Result<Atlas> run_atlas(const AtlasPlan& plan, const std::filesystem::path& scratch,
                        Progress& progress);

/// The same, written to `folder` as atlas.html, atlas.json and atlas.csv, which appear together and
/// complete or not at all. The folder is made if it is missing.
Result<Atlas> make_atlas(const AtlasPlan& plan, const std::filesystem::path& folder,
                         Progress& progress);

}  // namespace splitsum
