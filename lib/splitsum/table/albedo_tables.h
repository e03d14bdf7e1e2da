#pragma once

#include <span>

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/image/table.h"
#include "splitsum/plan/table_plan.h"
#include "splitsum/table/grid.h"

namespace splitsum {

// Tables of one number, the directional albedo of a lobe without Fresnel: how much of uniform light a
// view gets back. What lies below such a lobe is multiplied with 1 - albedo. Each pair is
// TableKind::bake and TableKind::error_of; errors of values above 1 are relative.

/// Cloth (Estevez & Kulla 2017) with the visibility of Neubelt & Pettineo 2013, the table that Filament
/// and KHR_materials_sheen name; see brdf/charlie.h for the terms.
Result<Table> bake_charlie(const TablePlan& plan, const TableGrid& grid, Progress& progress);
double error_of_charlie(const TablePlan& plan, double n_dot_v, double perceptual_roughness,
                        std::span<const double> read);

/// The same with the visibility clamped to 1, as Khronos' sampler and the shaders of three.js do.
Result<Table> bake_charlie_clamped(const TablePlan& plan, const TableGrid& grid,
                                   Progress& progress);
double error_of_charlie_clamped(const TablePlan& plan, double n_dot_v, double perceptual_roughness,
                                std::span<const double> read);

/// The same with the paper's own shadowing.
Result<Table> bake_charlie_smith(const TablePlan& plan, const TableGrid& grid, Progress& progress);
double error_of_charlie_smith(const TablePlan& plan, double n_dot_v, double perceptual_roughness,
                              std::span<const double> read);

/// Burley 2012.
Result<Table> bake_diffuse_disney(const TablePlan& plan, const TableGrid& grid, Progress& progress);
double error_of_diffuse_disney(const TablePlan& plan, double n_dot_v, double perceptual_roughness,
                               std::span<const double> read);

/// Lagarde & de Rousiers 2014.
Result<Table> bake_diffuse_renormalised(const TablePlan& plan, const TableGrid& grid,
                                        Progress& progress);
double error_of_diffuse_renormalised(const TablePlan& plan, double n_dot_v,
                                     double perceptual_roughness, std::span<const double> read);

}  // namespace splitsum
