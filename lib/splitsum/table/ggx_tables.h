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

/// (E, E_avg): the directional albedo E(n·v, r) = a + b for F = 1, and the average albedo
/// E_avg(r) = 2 ∫ E(mu, r) mu dmu, the same in every column. What one bounce loses comes back as
///     f_ms = (1 - E(n·v)) (1 - E(n·l)) / (pi (1 - E_avg))
/// (Kulla & Conty 2017, "Revisiting Physically Based Shading at Imageworks"; for image-based light
/// Fdez-Agüera 2019, "A Multiple-Scattering Microfacet Model for Real-Time Image-based Lighting").
Result<Table> bake_energy(const TablePlan& plan, const TableGrid& grid, Progress& progress);
double error_of_energy(const TablePlan& plan, double n_dot_v, double perceptual_roughness,
                       std::span<const double> read);

/// (1 - E, what a sampler with a linear filter makes of 2 ∫ (1 - E) mu dmu), the same for smooth
/// surfaces too, where 1 - E is far below the steps that floats have near 1, and where no table resolves
/// views as grazing as the lobe is wide: the average is that of what is read, so that light between the
/// facets gives back what was lost exactly, for tables of every size. Its error against E_avg is that of
/// the linear filter.
Result<Table> bake_energy_lost(const TablePlan& plan, const TableGrid& grid, Progress& progress);
double error_of_energy_lost(const TablePlan& plan, double n_dot_v, double perceptual_roughness,
                            std::span<const double> read);

}  // namespace splitsum
