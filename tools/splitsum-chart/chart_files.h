#pragma once

#include <filesystem>
#include <string>

#include "splitsum/base/result.h"
#include "splitsum/chart/chart.h"

namespace splitsum::tools {

/// Writes chart.csv, storage.csv, chart.json, chart.gnuplot, the pictures chart.svg, chart.png,
/// storage.svg and storage.png, and chart.html to `folder`, all of them or none. Without a plotter
/// there are no pictures; the result then says why, and is "" otherwise. Fails with
/// unwritable_output.
Result<std::string> write_chart_files(const Chart& chart, const std::filesystem::path& folder);

}  // namespace splitsum::tools
