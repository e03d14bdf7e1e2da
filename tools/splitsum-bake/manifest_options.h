#pragma once

#include <CLI/CLI.hpp>

#include <span>
#include <vector>

#include "splitsum/bake/bake.h"
#include "splitsum/manifest/manifest.h"

namespace splitsum::tools {

/// The options of `app` as manifests may name them: those that PlanOptions registers for each
/// panorama, a few on the command line alone, all others for the whole run.
std::vector<KnownOption> options_of_manifests(const CLI::App& app);

/// How one panorama is read and what is made of it.
struct PanoramaPlan {
    PanoramaOptions reading;
    BakePlan plan;
};

/// The plans that the settings of `panoramas` mean, in their order. Each is parsed as if it had been
/// typed, so that a key means what the option means. What was typed for `app`, which has parsed the
/// command line, overrides all settings; the environment overrides none.
///
/// Fails with bad_argument: up to ten problems, a line each, with the place of the setting, or of
/// the panorama where settings do not fit together. Cost: 0.1 ms for each set of settings that
/// differs from the others.
Result<std::vector<PanoramaPlan>> plans_of_manifest(std::span<const ManifestPanorama> panoramas,
                                                    const CLI::App& app);

/// Gives the options of the whole run that were not typed the values of the manifest. What was bound
/// to them changes. Fails with bad_argument, with the place of the setting.
Status apply_run_settings(CLI::App& app, std::span<const Setting> settings);

}  // namespace splitsum::tools
