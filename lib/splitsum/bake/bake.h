#pragma once

#include <filesystem>
#include <optional>

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/container/containers.h"
#include "splitsum/filter/asset_levels.h"
#include "splitsum/panorama/panorama.h"
#include "splitsum/report/bake_report.h"

namespace splitsum {

/// Everything to make of one panorama, and how. Pure data: equal plans and panoramas give equal
/// bytes in every file.
struct BakePlan {
    SpecularPlan specular;
    IrradiancePlan irradiance;
    FilterPlan filter;
    Orientation orientation;
    PixelFormat format = PixelFormat::rgba16f;
    ContainerOptions container;
    /// Texels a level that are measured against exact integration; affordable_probes if not given.
    std::optional<int> probes;
    bool picture = true;  ///< write contact.png
};

/// Fails with bad_argument: what was asked, and what would work.
Status validate(const BakePlan& plan);

/// The main job: filters the panorama, stores specular.ktx2, irradiance.ktx2, harmonics.json and
/// contact.png in `folder` (made if it is missing), measures what was stored and writes report.json
/// and report.txt last. Each file appears whole or not at all; nothing is written before all of the
/// light is computed and measured.
///
/// Fails with bad_argument, unwritable_output or interrupted.
Result<BakeReport> bake(const Panorama& panorama, const BakePlan& plan,
                        const std::filesystem::path& folder, Progress& progress);

}  // namespace splitsum
