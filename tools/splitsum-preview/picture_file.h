#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "splitsum/base/result.h"
#include "splitsum/image/image.h"
#include "splitsum/preview/view.h"

namespace splitsum::tools {

/// Pictures of one scene, all of one size.
struct NamedPicture {
    std::string name;  ///< as in an EXR file
    Image picture;     ///< scene-linear
};

/// How a PNG shows them.
struct Shown {
    View view;
    double exposure_stops;
};

/// Whether `path` names a picture that can be written: .png or .exr. Fails with bad_argument or
/// unwritable_output.
Status check_picture_file(const std::filesystem::path& path);

/// Writes a .png of the pictures from top to bottom, or an .exr with a layer for each; a single one
/// has no layer. Fails with unwritable_output.
Status write_pictures(const std::vector<NamedPicture>& pictures, const Shown& shown,
                      const std::filesystem::path& path);

}  // namespace splitsum::tools
