#pragma once

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/math/vec.h"
#include "splitsum/plan/asset_plan.h"

namespace splitsum {

/// The split sum (Karis 2013, "Real Shading in Unreal Engine 4"): the directional albedo of a GGX
/// surface under constant light is F0 * a + b.
struct SplitSum {
    double a;
    double b;
};

}  // namespace splitsum
