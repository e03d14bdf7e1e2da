#pragma once

#include <string>
#include <vector>

#include "splitsum/base/result.h"
#include "splitsum/color/color_space.h"
#include "splitsum/imageio/image_file.h"
#include "splitsum/panorama/panorama.h"

namespace splitsum {

/// The colour space a file is taken to be in, and the way from there to the working space.
struct ColorChoice {
    ColorConverter converter;
    std::string name;
    std::vector<std::string> notes;
};

/// Chooses as read_panorama describes. Fails with bad_argument and unreadable_input.
Result<ColorChoice> choose_color_space(const ImageFileInfo& file, const PanoramaOptions& options);

}  // namespace splitsum
