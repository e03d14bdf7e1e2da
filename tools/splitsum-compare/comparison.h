#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

#include "common/exit_code.h"
#include "common/options.h"

namespace splitsum::tools {

/// Every option of splitsum-compare.
struct CompareOptions {
    explicit CompareOptions(CLI::App& app);
    CompareOptions(const CompareOptions&) = delete;

    std::string asset;
    std::string other;     ///< "" when a panorama is given
    std::string panorama;  ///< "" when another asset is given
    ReadingOptions reading;
    std::string kind;       ///< of a file that does not say: "specular", "irradiance" or ""
    std::string roughness;  ///< of a chain that does not say; "" for what the file says
    OrientationOptions orientation;
    std::vector<std::string> limits;
    int probes = 64;
    JsonOption json;
};

/// Prints the figures of every level and whether the asset's certificate holds; over_limit when a
/// figure exceeds a limit or the certificate does not hold.
Result<ExitCode> run_compare(const CompareOptions& options, Progress& progress);

}  // namespace splitsum::tools
