#pragma once

#include <span>
#include <string>

#include "splitsum/filter/methods.h"
#include "splitsum/verify/check_levels.h"
#include "splitsum/verify/reconstruction.h"

namespace splitsum {

/// The heading of the lines that figures_line writes, with or without accounts.
std::string figures_heading(bool with_accounts);

/// One line of a table of figures for people; `what` stands in the first column. Figures that were
/// not measured are dashes. With an account, the method and its error bound end the line.
std::string figures_line(const std::string& what, const LevelCheck& check,
                         const LevelAccount* account = nullptr);

/// What an engine reads between texels and levels: a heading and a line for each band of roughness.
std::string readings_text(std::span<const ReconstructionError> bands);

}  // namespace splitsum
