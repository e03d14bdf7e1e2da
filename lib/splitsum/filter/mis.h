#pragma once

#include <memory>
#include <span>

#include "splitsum/filter/methods.h"

namespace splitsum {

/// Multiple importance sampling: half of the samples through the lobe, half through the light,
/// combined by plan.heuristic and divided by the lobe's exact integral (mis_estimate.h). Unbiased
/// for the piecewise-constant environment: a small sun is found by one strategy, a narrow lobe by
/// the other. What it lacks in samples shows as noise, and standard_errors() says how much.
///
/// Points are random, or Hammersley's moved by an offset of their own at every texel (sequence.h).
/// fp64 throughout. Cost: about 0.2 microseconds a sample; see mis_light.h for memory.
std::unique_ptr<PreparedFilter> prepare_mis(const FilterSource& source, std::span<const Lobe> lobes,
                                            const FilterPlan& plan);

}  // namespace splitsum
