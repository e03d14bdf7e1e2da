#pragma once

#include <memory>
#include <span>

#include "splitsum/filter/methods.h"

namespace splitsum {

// The methods that average N directions about R. They share the sample set of a lobe (all texels
// of a level use the same one) and differ in how it is made and what a sample reads.

/// Hammersley points through the lobe's distribution; a sample reads the panorama's texel.
std::unique_ptr<PreparedFilter> prepare_importance(const FilterSource& source,
                                                   std::span<const Lobe> lobes,
                                                   const FilterPlan& plan);

/// A uniform grid over the hemisphere; a sample reads the panorama's texel.
std::unique_ptr<PreparedFilter> prepare_riemann(const FilterSource& source,
                                                std::span<const Lobe> lobes,
                                                const FilterPlan& plan);

/// Hammersley points; a sample reads the pyramid level whose texels cover about the solid angle
/// the sample stands for (Křivánek & Colbert 2008, "Real-Time Shading with Filtered Importance
/// Sampling", eq. 13; also GPU Gems 3, ch. 20), without their bias of one level.
std::unique_ptr<PreparedFilter> prepare_filtered(const FilterSource& source,
                                                 std::span<const Lobe> lobes,
                                                 const FilterPlan& plan);

}  // namespace splitsum
