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
#include "splitsum/verify/exact_probes.h"
#include "splitsum/verify/reconstruction.h"

namespace splitsum {

/// A panorama as the filters see it.
struct Light {
    Environment environment;
    std::shared_ptr<FilterTables> tables;

    /// Where the panorama was streamed, and `environment` is only an average of it to look at.
    std::optional<Spectrum> spectrum{};
    std::vector<Cubemap> mirrors{};
    /// What the texels to be measured should be: of each of probed_cubemaps.
    std::vector<ExactTexels> exact{};
    /// And what engines should read between texels and levels.
    std::optional<ReconstructionProbes> readings{};

    SourceFacts source{};
    PanoramaOptions reading{};  ///< how the panorama was read
    int width = 0;              ///< of the panorama
    int height = 0;
    std::vector<std::string> notes{};

    FilterSource filter_source() const;
};

/// What a light is loaded for.
struct LightUse {
    LevelsPlan levels;
    /// The caller will look at the texels itself: they must stay in memory.
    bool keep_texels = false;
    /// Texels a level that will be measured; default_probes if not given.
    std::optional<int> probes{};
    /// Shared by the lights of a run.
    std::shared_ptr<FilterTables> tables = std::make_shared<FilterTables>();
};

/// Reads a panorama in order to make levels of it.
///
/// Up to 1024 rows, or for methods that look at texels, all of it is kept. Larger ones are streamed
/// where the harmonics and the mirror level are all that is needed: rows are transformed and area-
/// filtered as they arrive, and the texels to be measured are integrated exactly, so that memory
/// follows the transform and the levels, not the file. If the light turns out to need more bands
/// than were guessed, the file is streamed once more.
///
/// Fails as read_panorama does.
Result<Light> load_light(const std::filesystem::path& path, const PanoramaOptions& options,
                         const LightUse& use, Progress& progress);

/// The cubemaps that are measured of what a plan makes, in order: the specular levels, irradiance,
/// and cubemap_of_harmonics beside it.
std::vector<ProbedCubemap> probed_cubemaps(const LevelsPlan& plan);

/// What the texels to be measured should be, of each of probed_cubemaps: as they were integrated
/// while the light was streamed for this plan, else integrated now, `probes` texels a level or
/// default_probes. Fails only when cancelled.
Result<std::vector<ExactTexels>> exact_texels(const Light& light, const LevelsPlan& plan,
                                              std::optional<int> probes, Progress& progress);

/// The same of what engines should read between texels and levels of the plan's chain: as many
/// places in each of roughness_bands.
Result<ReconstructionProbes> exact_readings(const Light& light, const LevelsPlan& plan,
                                            std::optional<int> probes, Progress& progress);

/// A panorama that is in memory.
Light light_of(const Panorama& panorama,
               std::shared_ptr<FilterTables> tables = std::make_shared<FilterTables>());

}  // namespace splitsum
