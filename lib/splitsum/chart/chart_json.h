#pragma once

#include <string>

#include "splitsum/chart/chart.h"

namespace splitsum {

/// Everything that was measured and under which conditions, as JSON; figures that are not finite are
/// null.
std::string chart_json(const Chart& chart);

}  // namespace splitsum
