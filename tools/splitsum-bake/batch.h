#pragma once

#include <CLI/CLI.hpp>

#include "common/exit_code.h"
#include "common/options.h"
#include "light/verify_options.h"
#include "splitsum/bake/bake.h"

namespace splitsum::tools {

/// Every option of splitsum-bake.
struct BatchOptions {
    explicit BatchOptions(CLI::App& app);
    BatchOptions(const BatchOptions&) = delete;

    /// Fails with bad_argument.
    Result<BakePlan> plan() const;

    InputOptions input;
    OutputOptions output;
    SpecularOptions specular;
    IrradianceOptions irradiance;
    TableOptions table;
    OrientationOptions orientation;
    FilterOptions filter;
    EncodingOptions encoding;
    VerifyOptions verify;
    JsonOption json;
    bool no_picture = false;
};

/// Bakes the table and every panorama and prints where the results are. A panorama that fails fails
/// itself only: the rest is baked, and the error, of the kind of the first failure, names them all.
Result<ExitCode> run_batch(const BatchOptions& options, Progress& progress);

}  // namespace splitsum::tools
