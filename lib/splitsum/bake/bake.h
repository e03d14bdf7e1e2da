#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "splitsum/bake/light.h"
#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/container/containers.h"
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
    /// Texels a level that are measured against exact integration, 0 for none; if not given,
    /// default_probes of verify/check_levels.h.
    std::optional<int> probes;
    bool picture = true;  ///< write contact.png
};

/// Fails with bad_argument: what was asked, and what would work.
Status validate(const BakePlan& plan);

/// What to load the light of a panorama for.
LightUse light_use(const BakePlan& plan, std::shared_ptr<FilterTables> tables);

/// Pictures of a bake that may lie in its folder: they show what was baked then, and go when
/// something else takes its place. splitsum-preview makes all but the first.
std::vector<std::string> drawn_files();

/// The main job: filters the light, stores specular.ktx2, irradiance.ktx2, harmonics.json and
/// contact.png in `folder` (made if it is missing), measures what was stored, writes a
/// certificate of it into the textures, and says what was done in report.txt and report.json. The
/// files appear together, report.json last (StagedFolder): a folder that has one is complete.
/// Nothing is written before all of the light is computed and measured.
///
/// Fails with bad_argument, unwritable_output, interrupted, or unreadable_input (the OpenColorIO
/// config of light.reading is gone).
Result<BakeReport> bake(const Light& light, const BakePlan& plan,
                        const std::filesystem::path& folder, Progress& progress);

}  // namespace splitsum
