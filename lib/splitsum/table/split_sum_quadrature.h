#pragma once

#include "splitsum/table/split_sum.h"

namespace splitsum {

/// The split sum by Gauss rules over half vectors (half_vector_rules.h) that end at the horizon.
/// `n_dot_v` and `alpha` in [0, 1], the ends included; alpha = 0 gives the exact limit. The absolute
/// error is below `tolerance` in [1e-9, 0.1]. Cost: 1 ms, nearly all of
/// it for the rules that a table shares; the sum itself takes about 1 us for 5e-7.
SplitSum split_sum_by_quadrature(SmithTerm term, double n_dot_v, double alpha, double tolerance);

/// The same over a grid, as SplitSumMethod::bake, to quadrature_tolerance(plan). Large
/// tables are read from a polynomial in ln(n·v) and ln(alpha) through fewer exact values
/// (chebyshev.h): 512² texels from 38 x 74 of them.
std::vector<SplitSum> split_sums_by_quadrature(const TablePlan& plan, const TableGrid& grid,
                                               Progress& progress);

}  // namespace splitsum
