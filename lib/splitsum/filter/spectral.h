#pragma once

#include <memory>
#include <span>

#include "splitsum/filter/methods.h"

namespace splitsum {

/// Filtering as what it is for zonal lobes: a product in spherical-harmonic space (Funk-Hecke),
/// exact but for the bands left out. One forward transform serves all lobes.
///
/// Each lobe keeps as many bands as this panorama needs (filter/band_limit.h), so that the bounds of
/// the truncation and of the interpolation on the synthesis grid stay under parts of plan.accuracy.
/// Lobes so narrow that they would need more than `most_bands` are taken apart (narrow_lobe.h): the
/// transform does the wide part, a sum over nearby texels the rest.
std::unique_ptr<PreparedFilter> prepare_spectral(const Environment& environment,
                                                 std::span<const Lobe> lobes,
                                                 const FilterPlan& plan);

}  // namespace splitsum
