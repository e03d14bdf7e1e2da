#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace splitsum::tools {

/// What is wrong with the arguments, as one line that says what would work; an unknown option is
/// named together with the option it comes nearest to.
std::string usage_message(const CLI::App& app, const CLI::ParseError& error);

}  // namespace splitsum::tools
