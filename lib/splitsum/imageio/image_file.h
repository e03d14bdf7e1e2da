#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "splitsum/base/result.h"
#include "splitsum/image/image.h"

namespace splitsum {

/// What a file says about its pixels.
struct ImageFileInfo {
    int width = 0;  ///< of the display window, upright
    int height = 0;
    std::string format_name;            ///< "hdr", "openexr", "tiff", ...
    std::vector<std::string> channels;  ///< every channel of the part that is read, in file order
    bool floating_point = false;        ///< half or float; otherwise integers, read as 0 ... 1
    std::string color_space;  ///< what the file says ("sRGB", "Linear", ...), "" if nothing
    std::optional<std::array<float, 8>> chromaticities;  ///< x, y of red, green, blue, white
    std::vector<std::string> notes;  ///< what was ignored or filled in, a sentence each
    int64_t reading_bytes = 0;       ///< memory that ImageReader::read_rows takes, an upper bound
};

/// Takes rows from the top down: `rgb` holds `row_count` whole rows of the display window, which are
/// the sink's to change until it returns.
using RowSink = std::function<Status(int first_row, int row_count, std::span<float> rgb)>;

/// The widest and highest image that is read: far above any panorama, far below an overflow.
inline constexpr int largest_image_side = 65536;

/// An image file that is open for reading: its description now, its rows band by band, so that no
/// one has to hold all of them.
///
/// Which channels are the colour: R, G, B without a layer name; else those of `layer`, which may be
/// left out where the file has one layer only; else a luminance Y or the only channel, as grey.
/// Alpha is dropped and colours stay as stored. Of a file with several parts the first with colour
/// is read. The display window is delivered: black where the file has no data.
class ImageReader {
public:
    /// Fails with unreadable_input (absent, a folder, empty, no image, cut short, absurd size),
    /// unusable_input (no colour channels, several layers and none chosen, luminance-chroma, ...)
    /// and bad_argument (`layer` is not in the file).
    static Result<ImageReader> open(const std::filesystem::path& path,
                                    const std::string& layer = {});

    ImageReader(ImageReader&&) noexcept;
    ImageReader& operator=(ImageReader&&) noexcept;
    ~ImageReader();

    const ImageFileInfo& info() const;

    /// Decodes the image from the top down, the next rows while the sink works on the last. The
    /// sink is called for one band of rows at a time, on any thread. Memory: three bands of 64 rows
    /// (fewer where rows are very long; 256 for DWAB; one row of tiles). Fails with
    /// unreadable_input where the file is cut short or corrupt, or with what the sink returned:
    /// with whichever comes first from the top.
    Status read_rows(const RowSink& sink);

private:
    struct State;
    explicit ImageReader(std::unique_ptr<State> state);

    std::unique_ptr<State> state_;
};

}  // namespace splitsum
