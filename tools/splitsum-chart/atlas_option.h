#pragma once

#include "common/exit_code.h"
#include "measuring.h"
#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"

namespace splitsum::tools {

/// --atlas: what every method makes of the cases at which methods fail, into the output folder. The
/// panoramas are generated, so that none may be named.
Result<ExitCode> run_atlas_option(const ChartOptions& options, Progress& progress);

}  // namespace splitsum::tools
