#pragma once

#include <filesystem>
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
    std::optional<Spectrum> spectrum;  ///< where `environment` is only an average of the light
    SourceFacts source;
    std::vector<std::string> notes;

    FilterSource filter_source() const { return {environment, spectrum ? &*spectrum : nullptr}; }
};

/// Reads a panorama for the levels of a plan.
///
/// Up to 1024 rows, or for methods that look at texels, all of it is kept. Larger ones are streamed
/// where the harmonics are all that is needed: each row is transformed and averaged down for the
/// mirror level as it arrives, so that memory follows the transform and the levels, not the file.
/// `keep_texels` prevents that, for callers that will integrate over the texels themselves.
///
/// Fails as read_panorama does.
Result<Light> load_light(const std::filesystem::path& path, const PanoramaOptions& options,
                         const LevelsPlan& plan, bool keep_texels, Progress& progress);

}  // namespace splitsum
