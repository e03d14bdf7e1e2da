#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/brdf/smith.h"
#include "splitsum/plan/table_plan.h"
#include "splitsum/table/grid.h"

namespace splitsum {

/// The split sum (Karis 2013, "Real Shading in Unreal Engine 4"): the directional albedo of a GGX
/// surface under constant light is F0 * a + b, with Schlick's Fresnel Fc = (1 - v·h)^5 and
///     a = ∫ (1 - Fc) D V n·l dl,   b = ∫ Fc D V n·l dl.
struct SplitSum {
    double a;
    double b;
};

/// The exact limit alpha = 0: b = (1 - n·v)^5 and a = 1 - b.
SplitSum mirror_split_sum(double n_dot_v);

/// One way to compute the split sum over a grid. All methods answer the same question, so any of
/// them can stand in for another, and each is tested against split_sum_exact.
struct SplitSumMethod {
    std::string_view name;     ///< as typed after --method
    std::string_view summary;  ///< one line for --help
    bool samples;              ///< whether TablePlan::samples matters
    /// The sums row by row of the grid, for a valid plan. Reports as many steps as there are rows.
    /// The same bits for every number of threads. Stops early when cancelled.
    std::vector<SplitSum> (*bake)(const TablePlan& plan, const TableGrid& grid, Progress& progress);
};

/// Every method; the first is the default.
std::span<const SplitSumMethod> split_sum_methods();

/// The method with that name. Fails with bad_argument, naming what there is.
Result<SplitSumMethod> find_split_sum_method(std::string_view name);

/// The sums of the plan's method over `grid`. Fails with bad_argument for a method that does not
/// exist and with interrupted when cancelled.
Result<std::vector<SplitSum>> split_sums(const TablePlan& plan, const TableGrid& grid,
                                         Progress& progress);

}  // namespace splitsum
