#pragma once

#include <optional>
#include <vector>

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/filter/filter_source.h"
#include "splitsum/filter/methods.h"
#include "splitsum/plan/asset_plan.h"
#include "splitsum/sphere/cubemap.h"
#include "splitsum/sphere/environment.h"

namespace splitsum {

/// The cubemaps to make of one environment, together so that a method can share work among them.
struct LevelsPlan {
    std::optional<SpecularPlan> specular;
    std::optional<IrradiancePlan> irradiance;
    FilterPlan filter;
    Orientation orientation;
};

struct AssetLevels {
    std::vector<LevelAccount> accounts;  ///< how each level was made, irradiance last
    std::vector<Cubemap> specular;  ///< level l has max(1, face_size >> l) texels along its edge
    std::optional<Cubemap> irradiance;  ///< E / pi, or E where the plan says so
};

/// Fails with bad_argument: what was asked, and what would work.
Status validate(const LevelsPlan& plan);

/// The lobes that the levels of the plan are filtered with, in order, without those of roughness 0.
std::vector<Lobe> lobes_of(const LevelsPlan& plan);

/// The face sizes of the levels of roughness 0.
std::vector<int> mirror_sizes(const LevelsPlan& plan);

/// Filters every level of the plan. Levels of roughness 0 are the area-filtered mirror image,
/// whatever the method. The bits do not depend on the number of threads.
///
/// Fails with bad_argument for an invalid plan, or with `interrupted`.
Result<AssetLevels> filter_levels(const FilterSource& source, const LevelsPlan& plan,
                                  Progress& progress);

}  // namespace splitsum
