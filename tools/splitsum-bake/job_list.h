#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bake_options.h"
#include "splitsum/base/result.h"
#include "splitsum/library/bake_library.h"

namespace splitsum::tools {

/// What is to be baked, and what that was read from.
struct JobList {
    std::vector<LibraryJob> jobs;
    /// Manifests, OpenColorIO configurations and searched folders: when one of them changes, the
    /// list or its results may.
    std::vector<std::filesystem::path> sources;
};

/// The panoramas of the command line, or of the manifest that it names, each with the options that
/// hold for it. Fails with bad_argument or unreadable_input before anything is baked.
Result<JobList> list_jobs(const BakeOptions& options);

}  // namespace splitsum::tools
