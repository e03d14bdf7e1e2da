#pragma once

#include <CLI/CLI.hpp>

#include "common/options.h"
#include "light/verify_options.h"
#include "splitsum/bake/bake.h"

namespace splitsum::tools {

/// The options that decide what is made of a panorama: everything that a manifest may set for each
/// panorama of its own.
struct PlanOptions {
    explicit PlanOptions(CLI::App& app);
    PlanOptions(const PlanOptions&) = delete;

    /// Fails with bad_argument.
    Result<BakePlan> plan() const;

    ReadingOptions reading;
    SpecularOptions specular;
    IrradianceOptions irradiance;
    OrientationOptions orientation;
    FilterOptions filter;
    EncodingOptions encoding;
    VerifyOptions verify;
    bool no_picture = false;
};

}  // namespace splitsum::tools
