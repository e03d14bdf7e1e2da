#pragma once

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/image/table.h"
#include "splitsum/plan/table_plan.h"
#include "splitsum/table/kinds.h"
#include "splitsum/table/self_check.h"
#include "splitsum/texture/texture_asset.h"

namespace splitsum {

/// A table as it is stored, with what was measured on it.
struct TableAsset {
    TableKind kind;
    TablePlan plan;        ///< with the size that was chosen
    Table table;           ///< what an engine reads back, arranged; the kind's channels only
    TextureAsset texture;  ///< with metadata; without texels where the kind is a closed form
    TableCheck check;      ///< of `table`
};

/// How a kind is stored where nothing else is asked for: half floats, of 4 channels where a texel has
/// more than 2; floats where those are too coarse.
PixelFormat default_format(const TableKind& kind);

/// Bakes a table of plan.kind, encodes it and measures what was stored, at texels and between them,
/// against the kind's independent reference. With an automatic size it takes the smallest power of
/// two, smallest_automatic_size to largest_automatic_size, whose error meets plan.accuracy.
///
/// Fails with bad_argument (also where the format cannot hold the table, or no size or not this
/// method and format meet the accuracy: the message says what was reached) or interrupted.
Result<TableAsset> bake_table(const TablePlan& plan, PixelFormat format, Progress& progress);

}  // namespace splitsum
