#pragma once

#include <CLI/CLI.hpp>

#include "common/exit_code.h"
#include "common/options.h"
#include "plan_options.h"

namespace splitsum::tools {

/// Every option of splitsum-bake.
struct BatchOptions {
    explicit BatchOptions(CLI::App& app);
    BatchOptions(const BatchOptions&) = delete;

    std::vector<std::string> panoramas;
    OutputOptions output;
    PlanOptions asset;
    TableOptions table;
    JsonOption json;
};

/// Bakes the table and every panorama and prints where the results are. A panorama that fails fails
/// itself only: the rest is baked, and the error, of the kind of the first failure, names them all.
Result<ExitCode> run_batch(const BatchOptions& options, Progress& progress);

}  // namespace splitsum::tools
