#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/filter/asset_levels.h"
#include "splitsum/panorama/panorama.h"
#include "splitsum/report/asset_facts.h"

namespace splitsum {

/// A panorama as the filters see it.
struct Light {
    Environment environment;
    std::shared_ptr<FilterTables> tables;

    /// Where the panorama was streamed, and `environment` is only an average of it to look at.
    std::optional<Spectrum> spectrum{};
    std::vector<Cubemap> mirrors{};

    SourceFacts source{};
    int width = 0;  ///< of the panorama
    int height = 0;
    std::vector<std::string> notes{};

    FilterSource filter_source() const;
};

/// What a light is loaded for.
struct LightUse {
    LevelsPlan levels;
    /// The caller will integrate over the texels itself: they must stay in memory.
    bool keep_texels = false;
    /// Shared by the lights of a run.
    std::shared_ptr<FilterTables> tables = std::make_shared<FilterTables>();
};

/// Reads a panorama in order to make levels of it.
///
/// Up to 1024 rows, or for methods that look at texels, all of it is kept. Larger ones are streamed
/// where the harmonics and the mirror level are all that is needed: rows are transformed and area-
/// filtered as they arrive, so that memory follows the transform and the levels, not the file. If
/// the light turns out to need more bands than were guessed, the file is streamed once more.
///
/// Fails as read_panorama does.
Result<Light> load_light(const std::filesystem::path& path, const PanoramaOptions& options,
                         const LightUse& use, Progress& progress);

/// How many texels a level can be measured in the time of a bake: as many as affordable_probes of
/// verify/check_levels.h says, none where the texels of the panorama were not kept.
int affordable_probes(const Light& light);

/// A panorama that is in memory.
Light light_of(const Panorama& panorama,
               std::shared_ptr<FilterTables> tables = std::make_shared<FilterTables>());

}  // namespace splitsum
