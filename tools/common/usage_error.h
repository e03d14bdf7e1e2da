#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <string_view>

namespace splitsum::tools {

/// What is wrong with the arguments, as one line that says what would work; an unknown option is
/// named together with the option it comes nearest to.
std::string usage_message(const CLI::App& app, const CLI::ParseError& error);

/// The fewest single-letter insertions, deletions and replacements that turn `from` into `to`
/// (Levenshtein 1966). Cost: from.size() * to.size().
size_t edit_distance(std::string_view from, std::string_view to);

}  // namespace splitsum::tools
