#pragma once

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/image/table.h"
#include "splitsum/plan/table_plan.h"
#include "splitsum/table/grid.h"

namespace splitsum {

// The tables that hold the split sum (a, b) of a GGX surface in one form or another; each pair is
// TableKind::bake and TableKind::error_of.

/// (a, b): the directional albedo is F0 a + b (Karis 2013).
Result<Table> bake_ggx(const TablePlan& plan, const TableGrid& grid, Progress& progress);
double error_of_ggx(const TablePlan& plan, double n_dot_v, double perceptual_roughness,
                    std::span<const double> read);

/// (b, a + b): the albedo is mix(x, y, F0), and y alone gives the energy compensation
/// 1 + F0 (1 / y - 1) of Turquin 2019, "Practical multiple scattering compensation for microfacet
/// models".
Result<Table> bake_ggx_multiscatter(const TablePlan& plan, const TableGrid& grid,
                                    Progress& progress);
double error_of_ggx_multiscatter(const TablePlan& plan, double n_dot_v, double perceptual_roughness,
                                 std::span<const double> read);

}  // namespace splitsum
