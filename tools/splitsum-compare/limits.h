#pragma once

#include <string>
#include <vector>

#include "splitsum/base/result.h"
#include "splitsum/measure/error_figures.h"

namespace splitsum::tools {

/// A figure by name and the largest value that passes.
struct Limit {
    std::string figure;  ///< rel_rms, max_rel, max_abs or bias (its absolute value)
    double value;
};

/// Reads "rel_rms=0.01" or "0.01", which means rel_rms. Fails with bad_argument.
Result<Limit> parse_limit(const std::string& text);

/// The names of the figures that exceed their limits, with both numbers; a figure that is not a
/// number exceeds every limit.
std::vector<std::string> exceeded(const ErrorFigures& figures, const std::vector<Limit>& limits);

}  // namespace splitsum::tools
