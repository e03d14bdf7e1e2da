#pragma once

#include <ostream>
#include <string>

#include "splitsum/chart/chart.h"

namespace splitsum {

/// "sunset: reflections, roughness 0.25".
std::string title_of(const PanelFacts& facts);

/// How much a drawing of a panel says: alone it has room for axis titles, a legend, and the last
/// effort of every line.
enum class PanelDetail { overview, alone };

/// The rows of all panels as gnuplot's data blocks.
void add_panel_data(std::ostream& out, const Chart& chart);

/// How many lines the key of panel `index` has.
size_t legend_entries(const Chart& chart, size_t index);

/// The commands that draw panel `index`, at the margins that are set.
void draw_panel(std::ostream& out, const Chart& chart, size_t index, PanelDetail detail);

/// The lines of all methods with their names, and nothing else.
void draw_legend(std::ostream& out, const Chart& chart);

}  // namespace splitsum
