#pragma once

#include "common/exit_code.h"
#include "preview_options.h"
#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"

namespace splitsum::tools {

/// Draws the scene under the baked light, writes the picture and prints what was measured.
Result<ExitCode> run_preview(const PreviewOptions& options, Progress& progress);

}  // namespace splitsum::tools
