#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/image/image.h"
#include "splitsum/image/statistics.h"

namespace splitsum {

/// How to turn a file into scene-linear radiance.
struct PanoramaOptions {
    std::string color_space;  ///< of the file; "" for what the file says, else scene-linear
    std::filesystem::path ocio_config;  ///< an OpenColorIO config; "" for the built-in one
    std::string layer;                  ///< of an EXR file; "" for the default or the only one
    double exposure_stops = 0;          ///< radiance is multiplied by 2^exposure_stops
    bool repair = false;  ///< replace NaN and Inf from neighbours, set negatives to zero; counted
};

/// A lat-long panorama in scene-linear Rec.709, and where it came from.
struct Panorama {
    Image pixels;             ///< width = 2 * height; finite and >= 0
    std::string source;       ///< the file's name without folders
    std::string source_hash;  ///< "xxh3-128:" and 32 hexadecimal digits
    std::string color_space;  ///< what the file was taken to be in
    double exposure_stops = 0;
    Census found;              ///< NaN, Inf and negative values in the file
    int64_t out_of_gamut = 0;  ///< clean pixels that Rec.709 can express with negative values only
    bool repaired = false;     ///< `found` was repaired and `out_of_gamut` set to zero
    std::vector<std::string> notes;  ///< what was ignored or filled in, a sentence each
    PanoramaOptions reading;         ///< how it was read
};

/// Reads any 2:1 lat-long image that OpenImageIO knows: rows, census, repair, colour conversion,
/// exposure, in this order.
///
/// The colour space is `color_space`, else that of the file's chromaticities, else the one that the
/// file names, else the config's scene_linear. Clean colours outside the gamut of Rec.709 become
/// negative in the conversion. A filter would spread negative light, so they are treated like
/// negative values of the file: refused, or with `repair` set to zero and counted; never clamped
/// silently.
///
/// Progress: the stage "read", one step a row.
/// Fails with unreadable_input (absent, truncated, corrupt, absurd header; config unreadable),
/// unusable_input (not 2:1, no colour channels, NaN, Inf or negative values without `repair`: count
/// and first position are named; infinite after the exposure), bad_argument (unknown colour space
/// or layer, exposure not finite) and interrupted.
Result<Panorama> read_panorama(const std::filesystem::path& path, const PanoramaOptions& options,
                               Progress& progress);

/// The size of the panorama in a file, without reading its pixels. Fails as read_panorama does.
struct PanoramaSize {
    int width;
    int height;
    int64_t reading_bytes = 0;  ///< memory that streaming the file takes, an upper bound; with all
                                ///< pixels where they may have to be repaired
};
Result<PanoramaSize> panorama_size(const std::filesystem::path& path,
                                   const PanoramaOptions& options);

/// Takes the rows of a panorama band by band, from the top down: `rgb` holds `row_count` rows.
using PanoramaRows = std::function<void(int first_row, int row_count, std::span<const float> rgb)>;

/// The same as read_panorama, without keeping the pixels: rows go to `rows` as they are read, and
/// `pixels` of the result stays empty. The next rows are decoded while `rows` works, which is called
/// for one band at a time, on any thread. Memory: a few bands of rows (ImageReader::read_rows).
///
/// What cannot be decided band by band is not: a file with defects or colours out of gamut is left
/// to read_panorama (then `rows` gets all of it at once), after a call of `restart` that takes back
/// the rows so far. Fails as read_panorama does.
Result<Panorama> stream_panorama(const std::filesystem::path& path, const PanoramaOptions& options,
                                 const PanoramaRows& rows, const std::function<void()>& restart,
                                 Progress& progress);

}  // namespace splitsum
