#pragma once

#include "splitsum/table/split_sum.h"

namespace splitsum {

/// One texel the way tables are usually baked (Karis 2013): half vectors drawn from the distribution
/// of normals D with `samples` Hammersley points, weighed by 4 V n·l v·h / n·h. For comparison: at
/// grazing views most of those normals face away from the viewer, and 1024 points miss by up to 0.024
/// (size 128) where those of split_sum_vndf.h miss by 0.0017. `n_dot_v` and `alpha` in [0, 1]; alpha
/// = 0 gives the exact limit. fp64, so that the error is the method's alone.
SplitSum split_sum_by_importance(SmithTerm term, double n_dot_v, double alpha, int samples);

/// The same over a grid, as SplitSumMethod::bake.
std::vector<SplitSum> split_sums_by_importance(const TablePlan& plan, const TableGrid& grid,
                                               Progress& progress);

}  // namespace splitsum
