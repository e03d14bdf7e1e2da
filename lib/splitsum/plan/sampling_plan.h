#pragma once

#include <span>

#include "splitsum/plan/table_plan.h"

namespace splitsum {

/// Which points of the unit square a sampling method turns into directions.
enum class PointSequence {
    hammersley,  ///< evenly spread: errors shrink nearly with 1 / N on smooth light
    random,      ///< independent, other ones at every texel: errors shrink with 1 / sqrt N
};

/// How multiple importance sampling weighs a direction that either strategy could have drawn
/// (Veach & Guibas 1995, "Optimally Combining Sampling Techniques for Monte Carlo Rendering").
enum class MisHeuristic {
    power,    ///< by the square of the density (beta = 2): less noise where one strategy fits
    balance,  ///< by the density itself
};

/// The default comes first.
std::span<const NamedValue<PointSequence>> point_sequences();
std::span<const NamedValue<MisHeuristic>> mis_heuristics();

}  // namespace splitsum
