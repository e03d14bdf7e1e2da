#pragma once

#include <filesystem>

#include "splitsum/base/result.h"

namespace splitsum::tools {

/// Runs `gnuplot`, found in PATH, with `script` in `folder`, where the pictures then are. Fails with
/// internal, in words for the page and the terminal: that it is not installed and which package
/// brings it, or what it complained about. A SIGINT of the terminal does not reach it.
Status run_gnuplot(const std::filesystem::path& script, const std::filesystem::path& folder);

}  // namespace splitsum::tools
