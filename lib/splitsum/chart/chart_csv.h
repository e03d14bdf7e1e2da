#pragma once

#include <string>

#include "splitsum/chart/chart.h"

namespace splitsum {

/// The rows of all panels, a line each under a line of names; fields with a comma or a quote are
/// quoted (RFC 4180, but for the line ends). Figures that are not finite are "nan" or "inf".
std::string chart_csv(const Chart& chart);

/// What engines read from stored chains: a line for each chain and band.
std::string storage_csv(const Chart& chart);

}  // namespace splitsum
