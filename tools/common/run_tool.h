#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <string>

#include "common/exit_code.h"
#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"

namespace splitsum::tools {

/// Parses the arguments, runs `body` and returns the exit code: the only place where errors become
/// messages and exits.
///
/// `app` has the tool's name, options and an example as its footer; --threads, --quiet, --version
/// and the exit codes in --help are added here. Every failure, exceptions of third parties
/// included, prints one line on stderr, "<tool>: <what was asked, found, would work>". SIGINT and
/// SIGTERM make Progress::cancelled() true, a second one ends the process at once.
int run_tool(CLI::App& app, int argc, char** argv,
             const std::function<Result<ExitCode>(Progress&)>& body);

/// The same for a body that has no exit code of its own.
int run_tool(CLI::App& app, int argc, char** argv, const std::function<Status(Progress&)>& body);

/// The text on one line, without blanks at its end: messages of third parties may span several.
std::string one_line(std::string text);

}  // namespace splitsum::tools
