#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "splitsum/bake/recipe.h"
#include "splitsum/base/result.h"

namespace splitsum {

/// What report.json of an earlier bake says, as far as it is asked again.
struct BakedReport {
    struct File {
        std::string name;
        int64_t bytes = 0;
        std::string hash;  ///< of its bytes
    };

    int algorithm = 0;
    std::string recipe;
    Settings settings;
    std::string source_name;
    std::string source_hash;
    std::vector<File> files;  ///< without the reports
    /// The largest error of the levels beyond the mirror image; nothing if none was measured.
    std::optional<double> worst_rel_rms;
};

/// Reads `folder`/report.json. Fails with unreadable_input: there is none, it is of a version that
/// recorded no recipe, or no report.
Result<BakedReport> read_baked_report(const std::filesystem::path& folder);

}  // namespace splitsum
