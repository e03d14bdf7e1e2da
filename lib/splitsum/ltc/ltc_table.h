#pragma once

#include <span>
#include <vector>

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/ltc/fit.h"

namespace splitsum {

/// What is stored of a fit.
struct LtcFit {
    /// How far a magnitude may be from 1: no more than this is lost or won where all of a lobe is lit.
    static constexpr double most_change = 0.01;

    LtcInverse inverse;
    double magnitude;  ///< over the albedo of the target, from 1 - most_change to 1 + most_change
};

/// The fits over a grid of views and roughness, both in [0, 1] and in any order:
/// element row * n_dot_v.size() + column is of n_dot_v[column] and perceptual_roughness[row].
/// Column by column in parallel, every column from the roughest surface to the smoothest, each fit
/// from the one before. The same bits for every number of threads. Reports n_dot_v.size() steps;
/// fails with interrupted when cancelled. Cost: about 1 ms an element, 64 x 64 in 1.5 s on 4 cores.
Result<std::vector<LtcFit>> fit_ltc_table(LtcTarget target, std::span<const double> n_dot_v,
                                          std::span<const double> perceptual_roughness,
                                          Progress& progress, const LtcFitPlan& plan = {});

}  // namespace splitsum
