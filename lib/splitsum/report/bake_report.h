#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "splitsum/filter/methods.h"
#include "splitsum/report/asset_facts.h"
#include "splitsum/texture/pixel_format.h"
#include "splitsum/verify/check_levels.h"
#include "splitsum/verify/reconstruction.h"

namespace splitsum {

/// A file that a bake wrote.
struct WrittenFile {
    std::string name;  ///< within the bake's folder
    int64_t bytes = 0;
    std::string what;  ///< what a lookup in it means
    std::string hash;  ///< of all its bytes: "xxh3-128:" and 32 hexadecimal digits
};

/// What was asked, done and measured for one panorama. Without times, so that equal inputs give
/// equal reports.
struct BakeReport {
    /// What decides the bytes of everything baked, as a hash, and the options in it; bake/recipe.h.
    std::string recipe;
    std::vector<std::pair<std::string, std::string>> settings;

    SourceFacts source;
    int source_width = 0;
    int source_height = 0;
    Vec3d source_mean_radiance{0};
    std::vector<std::string> notes;  ///< what was ignored, filled in or repaired, a sentence each

    AssetFacts specular_facts;
    AssetFacts irradiance_facts;
    PixelFormat format = PixelFormat::rgba16f;

    std::vector<WrittenFile> files;

    std::vector<LevelAccount> accounts;  ///< how each specular level and the irradiance were made

    int probes = 0;  ///< texels measured a level
    std::vector<LevelCheck> specular;
    std::vector<EncodeCounts> specular_counts;  ///< a level each
    /// What an engine reads between texels and levels, for each band of roughness.
    std::vector<ReconstructionError> between;
    LevelCheck irradiance;
    EncodeCounts irradiance_counts;
    LevelCheck harmonics;
    double harmonics_lowest = 0;  ///< as IrradianceHarmonics::lowest
};

/// The report as one JSON object; report.schema.json says what is in it.
std::string report_json(const BakeReport& report);

/// The same for people: a table of levels and figures.
std::string report_text(const BakeReport& report);

}  // namespace splitsum
