#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>

#include "splitsum/base/result.h"
#include "splitsum/image/image.h"

namespace splitsum {

/// A picture in an EXR file that holds several of one size. The picture must outlive it.
struct ExrLayer {
    std::string name;  ///< in front of the channels: name.R, name.G, name.B; "": R, G, B
    const Image* picture;
};

/// Writes the layers as one EXR image of float channels, ZIP compression, scene-linear Rec.709
/// (without chromaticities, which is what that means in OpenEXR), `attributes` as text. The file
/// appears complete or not at all. Fails with bad_argument (no layers, or of different sizes) and
/// unwritable_output.
Status write_exr_layers(std::span<const ExrLayer> layers,
                        const std::map<std::string, std::string>& attributes,
                        const std::filesystem::path& path);

}  // namespace splitsum
