#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "splitsum/base/result.h"
#include "splitsum/image/image.h"
#include "splitsum/preview/truth_picture.h"
#include "splitsum/preview/view.h"

namespace splitsum::tools {

/// The pictures of one run, scene-linear and of one size.
struct Pictures {
    Image baked;
    std::optional<TruthPicture> truth;
    Image truth_image;     ///< of the truth, before the background
    Image standard_error;  ///< of the truth
};

/// How a PNG shows them.
struct Shown {
    View view;
    double exposure_stops;
};

/// Whether `path` names a picture that can be written: .png or .exr. Fails with bad_argument or
/// unwritable_output.
Status check_picture_file(const std::filesystem::path& path);

/// Writes them: a .png with baked light, the truth and their difference (preview/difference.h) from
/// top to bottom, or an .exr with the layers baked, truth and standard_error; without a truth the
/// baked picture alone, which then is no layer. Fails with unwritable_output.
Status write_pictures(const Pictures& pictures, const Shown& shown,
                      const std::filesystem::path& path);

/// The names of what write_pictures() puts into that file, in order.
std::vector<std::string> picture_names(const Pictures& pictures, const std::filesystem::path& path);

}  // namespace splitsum::tools
