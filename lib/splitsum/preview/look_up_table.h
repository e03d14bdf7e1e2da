#pragma once

#include "splitsum/base/result.h"
#include "splitsum/image/table.h"
#include "splitsum/plan/table_plan.h"

namespace splitsum {

/// A stored table of `plan` as look_up() of table/split_sum_lookup.h reads it: (a, b), x = n·v, y =
/// perceptual roughness, texels at centres. Turned and flipped tables are turned back, and
/// `ggx-multiscatter` is converted texel by texel, which is exact between texels too.
///
/// Fails with unusable_input for other kinds, for texels at the edges and for an axis of alpha,
/// where values between texels would change: a clause that begins with "is" or "has" and ends with
/// the options of splitsum-brdf that would do.
Result<Table> look_up_table(const Table& stored, const TablePlan& plan);

}  // namespace splitsum
