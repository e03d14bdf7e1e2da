#pragma once

#include <memory>
#include <span>

#include "splitsum/filter/methods.h"

namespace splitsum {

/// The cheapest method that meets plan.accuracy for each lobe, and why it was taken. Today that is
/// `spectral` for every lobe: a sampling method needs more time for a hundredth of the accuracy
/// (tests/benchmarks/README.md), and lobes too narrow for the transform alone are taken apart inside
/// it. A lobe whose error bound cannot be brought under the accuracy goes to `reference`.
std::unique_ptr<PreparedFilter> prepare_auto(const FilterSource& source,
                                             std::span<const Lobe> lobes, const FilterPlan& plan);

}  // namespace splitsum
