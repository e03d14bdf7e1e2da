#pragma once

#include <span>
#include <string>
#include <vector>

#include "splitsum/brdf/lobe.h"
#include "splitsum/chart/chart_plan.h"
#include "splitsum/filter/methods.h"
#include "splitsum/plan/asset_plan.h"

namespace splitsum {

/// A method at one effort.
struct FilterRung {
    FilterMethod method{};
    FilterPlan plan{};
    std::string name{};  ///< the method's, and what sets this line apart from others of it
    std::string effort_name{};
    double effort = 0;
};

/// Every row of filter_methods() that filters `kind`, at each of its efforts: `accuracies` for
/// `spectral`, `samples` for all others, as far as their cost allows (the last rungs are left out of
/// methods that draw new points at every texel). Where a method has variants (random points, another
/// heuristic), each is a line of its own. Neither `reference`, which judges, nor `auto`, which
/// chooses among the others.
std::vector<FilterRung> filter_ladder(LobeKind kind, std::span<const int> samples,
                                      std::span<const double> accuracies);

/// A method that aims at an accuracy, at each of these.
std::vector<FilterRung> accuracy_ladder(const FilterMethod& method,
                                        std::span<const double> accuracies);

}  // namespace splitsum
