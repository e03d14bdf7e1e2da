#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace splitsum {

/// Numbers over a 2D grid, a few for each texel, in one layer or several of the same size: what a
/// renderer looks up instead of integrating.
struct Table {
    int width = 0;
    int height = 0;
    int channels = 2;           ///< of a texel of a layer
    int layers = 1;             ///< of a 2D array texture
    std::vector<float> values;  ///< layer by layer, row by row, texel by texel

    size_t texel_count() const {
        return static_cast<size_t>(width) * static_cast<size_t>(height) *
               static_cast<size_t>(layers);
    }

    /// The channels of one texel.
    std::span<float> texel(int x, int y, int layer = 0) {
        return {values.data() + index_of(x, y, layer), static_cast<size_t>(channels)};
    }
    std::span<const float> texel(int x, int y, int layer = 0) const {
        return {values.data() + index_of(x, y, layer), static_cast<size_t>(channels)};
    }

private:
    size_t index_of(int x, int y, int layer) const {
        const auto row =
            static_cast<size_t>(layer) * static_cast<size_t>(height) + static_cast<size_t>(y);
        return (row * static_cast<size_t>(width) + static_cast<size_t>(x)) *
               static_cast<size_t>(channels);
    }
};

/// A table of that shape full of zeros.
inline Table blank_table(int width, int height, int channels, int layers = 1) {
    Table table{width, height, channels, layers, {}};
    table.values.resize(table.texel_count() * static_cast<size_t>(channels));
    return table;
}

}  // namespace splitsum
