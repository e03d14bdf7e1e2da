#pragma once

#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>
#include <vector>

#include "common/exit_code.h"
#include "common/options.h"
#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"

namespace splitsum::tools {

/// PANORAMA..., how they are read, -o, --quick and --atlas.
struct ChartOptions {
    explicit ChartOptions(CLI::App& app);
    ChartOptions(const ChartOptions&) = delete;

    std::vector<std::string> panoramas;
    ReadingOptions reading;
    OutputOptions output;
    bool quick = false;
    bool atlas = false;
};

/// Measures the methods under the panoramas and writes the chart. Interrupted, it writes what was
/// measured until then and fails with interrupted.
Result<ExitCode> run_chart(const ChartOptions& options, Progress& progress);

}  // namespace splitsum::tools
