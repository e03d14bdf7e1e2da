#pragma once

#include <span>

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/image/table.h"
#include "splitsum/plan/table_plan.h"
#include "splitsum/table/grid.h"

namespace splitsum {

// Tables for polygonal lights by linearly transformed cosines (ltc/transformed_cosine.h): two layers
// of four channels over roughness and sqrt(1 - n·v), as engines have read them since Heitz et al.
// 2016 published theirs. three.js and Bevy expect 64 texels, layout edge, axes roughness-nv.
//
//     layer 0   m00, m20, m02, m22 of the inverse matrix, its middle entry 1; no unit
//     layer 1   the directional albedo for F = 1; the same weighted with Schlick's (1 - v·h)^5 (0 for
//               diffuse light); 0; the share of a sphere that the horizon leaves (clipped_sphere.h)
//
// Both are the exact integrals, but times one number from 0.99 to 1.01 with which the fitted lobe shades
// best (ltc/fit.h); and at n·v = 0 GGX has what makes the last interval right (ltc_between.h). Take
// integrals that must be exact, as for multiple scattering, from the tables that are made for them.
//
// A light of radiance L then adds L (F0 albedo + (F90 - F0) weighted) ltc_polygon_light(...) (Hill
// 2016, "LTC Fresnel Approximation"). The last channel has axes of its own: where the roughness axis
// runs from 0 to 1 the cosine from the normal to the sphere's centre runs from -1 to 1, and along the
// other axis its form factor from 0 to 1.
//
// Each pair is TableKind::bake and TableKind::error_of. Errors are the largest of |albedo - exact|,
// |weighted - exact| and |shaded - exact| for five polygons of radiance 1, small ones and large, of
// which some cross the horizon: fitted lobes are not the BRDF, so the last is not small.

/// GGX with height-correlated Smith.
Result<Table> bake_ltc_ggx(const TablePlan& plan, const TableGrid& grid, Progress& progress);
double error_of_ltc_ggx(const TablePlan& plan, double n_dot_v, double perceptual_roughness,
                        std::span<const double> read);

/// Burley's diffuse lobe.
Result<Table> bake_ltc_disney(const TablePlan& plan, const TableGrid& grid, Progress& progress);
double error_of_ltc_disney(const TablePlan& plan, double n_dot_v, double perceptual_roughness,
                           std::span<const double> read);

}  // namespace splitsum
