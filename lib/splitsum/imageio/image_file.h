#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "splitsum/base/result.h"
#include "splitsum/image/image.h"

namespace splitsum {

/// What a file says about its pixels.
struct ImageFileInfo {
    int width = 0;   ///< of the display window
    int height = 0;
    std::string format_name;               ///< "hdr", "openexr", "tiff", ...
    std::vector<std::string> channels;     ///< every channel of the file, in file order
    std::string color_space;               ///< oiio:ColorSpace, or "" when the file says nothing
    std::optional<std::array<float, 8>> chromaticities;  ///< x, y of red, green, blue, white
    std::vector<std::string> notes;        ///< what was ignored or filled in, a sentence each
};

/// Takes rows from the top down: `rgb` holds `row_count` whole rows of the display window.
using RowSink = std::function<Status(int first_row, int row_count, std::span<const float> rgb)>;

}  // namespace splitsum
