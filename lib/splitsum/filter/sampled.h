#pragma once

#include <memory>
#include <span>

#include "splitsum/filter/methods.h"

namespace splitsum {

// The methods that average N directions about R. All texels of a level share the sample set of
// its lobe, unless plan.sequence asks for random points: then each draws its own, which costs five
// to ten times as much. They differ in how the set is made and in what a sample reads.

/// Points through the lobe's distribution; a sample reads the panorama's texel.
std::unique_ptr<PreparedFilter> prepare_importance(const FilterSource& source,
                                                   std::span<const Lobe> lobes,
                                                   const FilterPlan& plan);

/// A uniform grid over the hemisphere, whatever the sequence; a sample reads the panorama's texel.
std::unique_ptr<PreparedFilter> prepare_riemann(const FilterSource& source,
                                                std::span<const Lobe> lobes,
                                                const FilterPlan& plan);

/// The same points; a sample reads the pyramid level whose texels cover about the solid angle
/// the sample stands for (Křivánek & Colbert 2008, "Real-Time Shading with Filtered Importance
/// Sampling", eq. 13; also GPU Gems 3, ch. 20), without their bias of one level.
std::unique_ptr<PreparedFilter> prepare_filtered(const FilterSource& source,
                                                 std::span<const Lobe> lobes,
                                                 const FilterPlan& plan);

}  // namespace splitsum
