#pragma once

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/plan/asset_plan.h"
#include "splitsum/texture/texture_asset.h"

namespace splitsum {

/// A split-sum table as it is stored, with what was measured on it.
struct TableAsset {
    TextureAsset texture;
    double max_abs = 0;  ///< largest error at the probe texels against split_sum_exact
    int probes = 0;
};

/// Bakes the table, encodes it and measures what was stored at texels spread over the table, its
/// corners and edges among them. Fails with bad_argument or interrupted.
Result<TableAsset> bake_table(const TablePlan& plan, PixelFormat format, Progress& progress);

}  // namespace splitsum
