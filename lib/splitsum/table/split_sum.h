#pragma once

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/image/table.h"
#include "splitsum/plan/asset_plan.h"

namespace splitsum {

/// The split sum (Karis 2013, "Real Shading in Unreal Engine 4"): the directional albedo of a GGX
/// surface under constant light is F0 * a + b.
struct SplitSum {
    double a;
    double b;
};

/// The whole table of `plan`: texel (x, y) is at n·v = (x + 1/2) / size and, in row 0, perceptual
/// roughness 0 exactly ... (to be completed)
Result<Table> split_sum_table(const TablePlan& plan, Progress& progress);

}  // namespace splitsum
