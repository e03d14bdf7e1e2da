#pragma once

#include <array>
#include <span>

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/image/table.h"
#include "splitsum/plan/table_plan.h"
#include "splitsum/table/grid.h"
#include "splitsum/table/split_sum.h"

namespace splitsum {

// The split sum without a texture: a and b as polynomials of degree 4 in three variables,
//     x = n·v,   r = perceptual roughness,   t = x / L,
//     L = sqrt(x² (1 - alpha²) + alpha²), or x (1 - k) + k of a Schlick term,   alpha = r².
// The third is what shadowing sees of the view, t = 1 for the mirror and 0 edge on: at the corner
// x = r = 0, where a and b depend on x / alpha alone and have no limit, no polynomial in x and r
// comes nearer than 0.1.

inline constexpr int fit_degree = 4;
inline constexpr int fit_terms = 35;

/// One coefficient pair (of a, of b) for each x^i r^j t^k with i + j + k <= fit_degree, in the order of
/// three nested loops: i outermost, k innermost.
using SplitSumFit = std::array<std::array<float, 2>, fit_terms>;

/// The fit of a geometry term as it ships. Largest error over [0, 1]²: see ggx-fit in
/// tests/benchmarks/tables.md; 0.014 height-correlated, 0.010 of the Schlick terms.
const SplitSumFit& shipped_fit(SmithTerm term);

/// The polynomials at a point, clamped to [0, 1]. `n_dot_v` and `perceptual_roughness` in [0, 1].
SplitSum evaluate(const SplitSumFit& fit, SmithTerm term, double n_dot_v,
                  double perceptual_roughness);

/// Makes the fit anew: least squares over 65 x 65 points, denser towards grazing views, whose weights
/// are multiplied by their errors again and again until the largest is as small as it gets (Lawson
/// 1961; Rice & Usow 1968, Math. Comp. 22). Deterministic. Cost: about 1 s. tests/benchmarks has the
/// program that prints split_sum_fit_coefficients.cpp.
SplitSumFit fit_split_sum(SmithTerm term);

// TableKind::bake, error_of and evaluate of the table ggx-fit, which holds (a, b).
Result<Table> bake_ggx_fit(const TablePlan& plan, const TableGrid& grid, Progress& progress);
void evaluate_ggx_fit(const TablePlan& plan, double n_dot_v, double perceptual_roughness,
                      std::span<double> read);

}  // namespace splitsum
