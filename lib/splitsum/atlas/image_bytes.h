#pragma once

#include <string>
#include <vector>

#include "splitsum/image/image.h"

namespace splitsum {

// Files of two formats that are simple enough to write byte by byte, with whatever a case wants in
// them that a writer of images would refuse to write. Each returns a whole file.

/// Portable float map (Debevec 2001): three floats a pixel, little-endian, bottom row first.
std::string pfm_bytes(const Image& image);

/// A window of an EXR file: its first pixel, and its size.
struct ExrWindow {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

/// A channel: where its values come from.
struct ExrPlane {
    std::string name;
    int channel = 0;  ///< 0, 1, 2: of the image; -1: `value` everywhere
    float value = 0;
};

/// OpenEXR 2 with scan lines and without compression ("OpenEXR File Layout", openexr.com), channels
/// of 32-bit floats. `pixels` fills the data window; `planes` in the order of their names.
std::string exr_bytes(const Image& pixels, const std::vector<ExrPlane>& planes,
                      const ExrWindow& data, const ExrWindow& display);

/// The same in half floats, which hold 0.5 in each channel of each pixel but for the first pixel,
/// whose red is Inf: what is left of a sun of 1e6 that was saved in such a file.
std::string overflowed_half_exr_bytes(int width, int height);

}  // namespace splitsum
