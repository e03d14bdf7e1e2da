#pragma once

#include <memory>
#include <span>

#include "splitsum/filter/methods.h"

namespace splitsum {

/// Filtering as what it is for zonal lobes: a product in spherical-harmonic space (Funk-Hecke),
/// exact but for the bands left out. One forward transform serves all lobes.
///
/// Each lobe keeps as many bands as this panorama needs: with the power spectrum S_l at hand, the
/// relative error of leaving out bands from B on is
///     sqrt(sum_{l >= B} k_l² S_l / sum_l k_l² S_l),
/// where the power beyond the computed bands is what they leave of ∫ L² dl. B is the smallest
/// number for which this bound is under a part of plan.accuracy.
std::unique_ptr<PreparedFilter> prepare_spectral(const Environment& environment,
                                                 std::span<const Lobe> lobes,
                                                 const FilterPlan& plan);

}  // namespace splitsum
