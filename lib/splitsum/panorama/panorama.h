#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/image/image.h"
#include "splitsum/image/statistics.h"

namespace splitsum {

/// How to turn a file into scene-linear radiance.
struct PanoramaOptions {
    std::string color_space;   ///< of the file; "" for what the file says, else scene-linear Rec.709
    std::filesystem::path ocio_config;  ///< an OpenColorIO config; "" for the built-in one
    double exposure_stops = 0; ///< radiance is multiplied by 2^exposure_stops
    bool repair = false;       ///< replace NaN and Inf from neighbours, set negatives to zero; counted
};

/// A lat-long panorama in scene-linear Rec.709, and where it came from.
struct Panorama {
    Image pixels;                    ///< width = 2 * height; finite and >= 0
    std::string source;              ///< the file's name without folders
    std::string source_hash;         ///< "xxh3-128:" and 32 hexadecimal digits
    std::string color_space;         ///< what the file was taken to be in
    double exposure_stops = 0;
    Census found;                    ///< NaN, Inf and negative values in the file
    bool repaired = false;           ///< `found` was repaired
    std::vector<std::string> notes;  ///< what was ignored or filled in, a sentence each
};

/// Reads any 2:1 lat-long image that OpenImageIO knows.
///
/// Fails with unreadable_input (absent, truncated, corrupt, absurd header), unusable_input (not
/// 2:1, no colour channels, NaN, Inf or negative values without `repair`: count and first position
/// are named) and bad_argument (unknown colour space or config).
Result<Panorama> read_panorama(const std::filesystem::path& path, const PanoramaOptions& options,
                               Progress& progress);

}  // namespace splitsum
