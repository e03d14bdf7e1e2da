#pragma once

#include <array>
#include <string>
#include <vector>

#include "splitsum/base/result.h"

namespace splitsum {

/// Which channels of a file are red, green and blue; three times the same for grey.
struct ChannelChoice {
    std::array<int, 3> rgb{};
    std::vector<std::string> notes;  ///< what was dropped, a sentence each
};

/// Chooses by name, as ImageReader describes. `layer` is "" for the default.
/// The error's message is a phrase that follows the file's name.
Result<ChannelChoice> choose_channels(const std::vector<std::string>& names,
                                      const std::string& layer);

}  // namespace splitsum
