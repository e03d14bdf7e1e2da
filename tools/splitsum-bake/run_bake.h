#pragma once

#include <CLI/CLI.hpp>

#include <span>
#include <string>

#include "bake_options.h"
#include "common/exit_code.h"
#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"

namespace splitsum::tools {

/// Brings the library that the options describe up to date, or checks it with --merge, and tells of
/// it: results on stdout, progress and failures on stderr. `app` has parsed the command line into
/// `options`; `command` is that command line. A panorama that fails fails itself only: the rest is baked, and the exit code is that
/// of the first failure.
Result<ExitCode> run_bake(CLI::App& app, const BakeOptions& options,
                          std::span<const std::string> command, Progress& terminal);

}  // namespace splitsum::tools
