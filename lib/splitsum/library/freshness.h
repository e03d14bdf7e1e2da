#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "splitsum/bake/recipe.h"
#include "splitsum/base/result.h"
#include "splitsum/library/baked_report.h"
#include "splitsum/library/source_memory.h"

namespace splitsum {

/// Whether a panorama has to be baked.
struct Freshness {
    bool up_to_date = false;
    std::string why;  ///< where it is not: "the options changed: accuracy 3e-04 -> 1e-04"
    /// What the earlier bake says of itself; nothing where there is none that can be read.
    std::optional<BakedReport> baked;
    /// The hash of the source, where it had to be known. If it was read for that, remember_source
    /// saves the next check from doing so.
    std::optional<SourceHash> source;
};

/// Compares what `folder` holds with what a bake of `source` by that plan would make: up to date is
/// what has a report whose recipe is that of now and every file that it lists, with its size. Writes
/// nothing.
///
/// The source is read only if everything else agrees and somebody wrote to it since it was
/// remembered. Cost otherwise: about 0.2 ms, most of it for reading report.json.
///
/// Fails with unreadable_input: the source, or the OpenColorIO config.
Result<Freshness> check_freshness(const std::filesystem::path& source,
                                  const PanoramaOptions& reading, const BakePlan& plan,
                                  const std::filesystem::path& folder, ConfigHashes& configs);

}  // namespace splitsum
