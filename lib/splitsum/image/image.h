#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace splitsum {

/// Scene-linear RGB, three interleaved floats a pixel, row 0 at the top.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<float> rgb;  ///< 3 * width * height values

    Image() = default;
    Image(int image_width, int image_height)
        : width(image_width),
          height(image_height),
          rgb(3 * static_cast<size_t>(image_width) * static_cast<size_t>(image_height)) {}

    std::span<float> row(int y) { return {rgb.data() + offset(y), 3 * static_cast<size_t>(width)}; }
    std::span<const float> row(int y) const {
        return {rgb.data() + offset(y), 3 * static_cast<size_t>(width)};
    }

private:
    size_t offset(int y) const { return 3 * static_cast<size_t>(y) * static_cast<size_t>(width); }
};

}  // namespace splitsum
