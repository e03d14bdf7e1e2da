#pragma once

#include <string>

#include "splitsum/atlas/atlas.h"

namespace splitsum {

/// The atlas as JSON: the plan and every entry, row and cell; figures that are not finite are null.
std::string json_of(const Atlas& atlas);

/// The atlas as CSV (RFC 4180), a line a cell: case, row, column, verdict, rel_rms, max_rel, bias,
/// max_abs, text. Figures are empty where the text says what happened.
std::string csv_of(const Atlas& atlas);

}  // namespace splitsum
