#pragma once

#include <CLI/CLI.hpp>

#include "bake_options.h"
#include "common/exit_code.h"
#include "job_list.h"
#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"

namespace splitsum::tools {

/// --merge: checks that every panorama of the list, and the table, is in the output folder, up to
/// date and true. Prints what was found on stdout; what is missing goes to stderr, a line each, with
/// the command that bakes it. The exit code is then over_limit.
Result<ExitCode> run_merge(const CLI::App& app, const BakeOptions& options, const JobList& list,
                           Progress& progress);

}  // namespace splitsum::tools
