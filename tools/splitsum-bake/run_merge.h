#pragma once

#include <span>
#include <string>

#include "bake_options.h"
#include "common/exit_code.h"
#include "job_list.h"
#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"

namespace splitsum::tools {

/// --merge: checks that every panorama of the list, and the table, is in the output folder, up to
/// date and true. Prints what was found on stdout; what is missing goes to stderr, a line each, with
/// then the command that bakes it: `command`, the arguments of this one, without --merge. The exit
/// code is then over_limit.
Result<ExitCode> run_merge(std::span<const std::string> command, const BakeOptions& options,
                           const JobList& list, Progress& progress);

/// The arguments as one line that a shell reads as them.
std::string shell_text(std::span<const std::string> arguments);

}  // namespace splitsum::tools
