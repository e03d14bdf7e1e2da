#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/chart/chart_plan.h"
#include "splitsum/chart/level_panels.h"
#include "splitsum/verify/reconstruction.h"

namespace splitsum {

/// What a stored chain of one size and format costs, and what an engine gets from it.
struct StoredChain {
    std::string panorama;
    std::string format;  ///< a name from pixel_formats()
    int face_size = 0;
    int levels = 0;                           ///< of the linear curve, down to faces of 4²
    int64_t bytes = 0;                        ///< of all texels, without a container
    int64_t saturated = 0;                    ///< channel values above what the format holds
    std::vector<ReconstructionError> errors;  ///< one a band of roughness
};

/// How many steps measure_storage reports.
int storage_steps(const ChartPlan& plan);

/// Makes chains of every size with `auto`, stores them in every format for colours of 16 bits a
/// channel or fewer, and reads them back as an engine does. Adds each to `chains` when it is known.
/// Fails with interrupted.
Status measure_storage(const NamedLight& light, const ChartPlan& plan,
                       std::vector<StoredChain>& chains, Progress& progress);

}  // namespace splitsum
