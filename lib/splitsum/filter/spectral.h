#pragma once

#include <memory>
#include <optional>
#include <span>

#include "splitsum/filter/methods.h"

namespace splitsum {

/// Filtering as what it is for zonal lobes: a product in spherical-harmonic space (Funk-Hecke),
/// exact but for the bands left out. One forward transform serves all lobes.
///
/// Each lobe keeps as many bands as this panorama needs (filter/band_limit.h), so that the bounds of
/// the truncation and of the interpolation on the synthesis grid stay under parts of plan.accuracy.
/// Lobes so narrow that a point light would need more than 2000 are taken apart (narrow_lobe.h): the
/// transform does the wide part, a sum over nearby texels the rest.
std::unique_ptr<PreparedFilter> prepare_spectral(const FilterSource& source,
                                                 std::span<const Lobe> lobes,
                                                 const FilterPlan& plan);

/// How many bands to transform before the light is known: enough for the narrow ones of these lobes
/// under a single point light, the worst case, and for the wide ones, whose factors fall off slowly
/// but meet little power up there, enough for all but the strongest suns. Nothing where a lobe is so
/// narrow that the texels themselves are needed.
std::optional<int> bands_to_transform(FilterTables& tables, std::span<const Lobe> lobes,
                                      double accuracy);

/// How many bands such a spectrum should have had for these lobes, which may be as many as it has.
int bands_needed(FilterTables& tables, const Spectrum& spectrum, std::span<const Lobe> lobes,
                 double accuracy);

}  // namespace splitsum
