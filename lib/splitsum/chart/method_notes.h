#pragma once

#include <vector>

#include "splitsum/chart/chart.h"

namespace splitsum {

/// One sentence for each line in the panels, in the order of first appearance; those of registered
/// methods are the summaries that --help shows.
std::vector<MethodNote> method_notes(const std::vector<MeasuredPanel>& panels);

}  // namespace splitsum
