#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/library/bake_library.h"

namespace splitsum {

/// What keeps a panorama's results from being whole and true.
struct MergeProblem {
    size_t job = 0;
    bool is_damaged = false;  ///< it looks up to date, and is not what it was certified to be
    std::string
        what;  ///< "there is no report yet", "specular.ktx2: the texels ... are not those ..."
};

/// What a library comes to after all of its parts were baked.
struct MergeCheck {
    std::vector<MergeProblem> problems;        ///< in the order of the list
    std::optional<std::string> table_problem;  ///< why the table is not the one that belongs here
    size_t damaged = 0;                        ///< of the problems
    size_t complete = 0;                       ///< panoramas without a problem
    int64_t bytes = 0;                         ///< of their files
    std::optional<double> worst_rel_rms;       ///< of those that were measured
    size_t worst = 0;                          ///< the job that has it

    bool holds() const { return problems.empty() && !table_problem; }
};

/// Whether `folder` holds the results of all jobs, whoever baked them: each up to date as
/// bake_library would find it, each file with the bytes that its report names, each cubemap as its certificate says, and the table. Writes nothing.
/// Cost: reads every result twice; sources only where somebody wrote to them since.
///
/// Progress: the stage "check", a step a panorama. Fails with bad_argument as bake_library does, and
/// with interrupted.
Result<MergeCheck> check_merged(std::span<const LibraryJob> jobs, const LibraryTable& table,
                                const std::filesystem::path& folder, Progress& progress);

}  // namespace splitsum
