#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "splitsum/image/image.h"

namespace splitsum::test_data {

/// A window as OpenEXR counts: from its first pixel to beyond its last.
struct Window {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

enum class ExrCompression { none, zip, piz, dwaa };

/// A channel of a file: a channel of the image, or one value everywhere.
struct ExrChannel {
    std::string name;
    int source = 0;  ///< 0, 1, 2: of the image; -1: `value`
    float value = 0;
};

/// What to write and how. The image fills the data window; the windows are the image's size where
/// they are empty.
struct ExrPlan {
    std::vector<ExrChannel> channels = {{"R", 0, 0}, {"G", 1, 0}, {"B", 2, 0}};
    bool half = true;
    int tile_size = 0;  ///< 0: scan lines
    ExrCompression compression = ExrCompression::zip;
    Window display;
    Window data;
    std::vector<float> chromaticities;  ///< 8 values, or none
};

/// These throw std::exception when writing fails.
void write_exr(const std::filesystem::path& path, const Image& image, const ExrPlan& plan = {});

/// Luminance and chroma, the chroma at half the resolution, as OpenEXR's own class writes them.
void write_luminance_chroma_exr(const std::filesystem::path& path, const Image& image);

/// Two parts: the first holds a depth Z alone, the second the colours.
void write_multi_part_exr(const std::filesystem::path& path, const Image& image);

}  // namespace splitsum::test_data
