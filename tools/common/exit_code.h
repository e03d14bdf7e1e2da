#pragma once

#include "splitsum/base/result.h"

namespace splitsum::tools {

/// The exit codes, the same in all tools and part of their documented interface.
enum class ExitCode {
    done = 0,
    over_limit = 1,  ///< a comparison found an error over its limit
    bad_arguments = 2,
    unreadable_input = 3,  ///< absent, truncated or corrupt
    unwritable_output = 4,
    unusable_input = 5,  ///< readable, but not usable: not 2:1, NaN texels, ...
    internal = 70,       ///< our own fault
    interrupted = 130,   ///< stopped by SIGINT or SIGTERM, outputs in progress dropped
};

/// The code with which a tool ends after an error of that kind.
ExitCode exit_code_of(ErrorKind kind);

/// The table of exit codes as --help prints it.
const char* exit_code_help();

}  // namespace splitsum::tools
