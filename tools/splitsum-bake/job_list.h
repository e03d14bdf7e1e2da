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
/// hold for it. `app` has parsed the command line into `options`; what a manifest says for the whole
/// run goes into them too. Fails, before anything is baked, with bad_argument, unreadable_input or
/// unusable_input.
Result<JobList> list_jobs(CLI::App& app, const BakeOptions& options);

}  // namespace splitsum::tools
