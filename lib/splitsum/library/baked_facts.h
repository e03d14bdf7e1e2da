#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "splitsum/library/baked_report.h"
#include "splitsum/report/bake_report.h"

namespace splitsum {

/// What summaries of a library tell of a baked folder.
struct BakedFacts {
    std::vector<BakedReport::File> files;  ///< without the reports
    std::optional<double> worst_rel_rms;   ///< beyond the mirror level; nothing if not measured
};

/// Of a bake of now, and of an earlier one.
BakedFacts facts_from(const BakeReport& report);
BakedFacts facts_from(const BakedReport& report);

/// Of all files together.
int64_t bytes_of(const BakedFacts& facts);

}  // namespace splitsum
