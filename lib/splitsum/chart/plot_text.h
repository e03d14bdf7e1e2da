#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "splitsum/chart/chart.h"

namespace splitsum {

// The words and numbers of gnuplot that the pictures are made of.

/// In double quotes, with what is special in them escaped.
std::string gnuplot_string(std::string_view text);

/// How the line of a method looks: its colour, marker and dashes depend on its place among all
/// methods of a chart, so that it is the same in every panel. The first seven differ in colour, all
/// of them in colour and marker together.
std::string line_style(size_t place);

/// The axis from the decade or part of it below `lowest` to above `highest`, both > 0.
struct LogRange {
    double from;
    double to;
};
LogRange range_around(double lowest, double highest);
std::string to_string(const LogRange& range);

/// The place of a method among `notes`.
size_t place_of(const std::vector<MethodNote>& notes, std::string_view method);

}  // namespace splitsum
