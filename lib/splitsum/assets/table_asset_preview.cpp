#include "splitsum/assets/table_asset_preview.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace splitsum {
namespace {

constexpr int gap = 8;
constexpr int least_tile = 256;
constexpr uint8_t background = 40;

struct Range {
    float low = 0;
    float high = 1;

    uint8_t grey(float value) const {
        return static_cast<uint8_t>(std::lround(255 * (value - low) / (high - low)));
    }
};

// Of each channel of a layer.
std::vector<Range> ranges_of(const Table& table, int layer) {
    std::vector<Range> ranges(static_cast<size_t>(table.channels));
    for (int y = 0; y < table.height; ++y)
        for (int x = 0; x < table.width; ++x)
            for (size_t c = 0; c < ranges.size(); ++c) {
                const float value = table.texel(x, y, layer)[c];
                ranges[c] = {std::min(ranges[c].low, value), std::max(ranges[c].high, value)};
            }
    return ranges;
}

// Tile 0 is the channels as a colour, tile c + 1 channel c.
std::array<uint8_t, 3> colour_in_tile(std::span<const float> texel,
                                      const std::vector<Range>& ranges, int tile) {
    if (tile > 0) {
        const auto channel = static_cast<size_t>(tile - 1);
        const uint8_t grey = ranges[channel].grey(texel[channel]);
        return {grey, grey, grey};
    }
    std::array<uint8_t, 3> colour{};
    for (size_t c = 0; c < std::min(colour.size(), texel.size()); ++c)
        colour[c] = ranges[c].grey(texel[c]);
    return colour;
}

}  // namespace

Preview preview_of(const Table& table) {
    const int enlarged = std::max(1, least_tile / std::max(table.width, table.height));
    const int tile_width = enlarged * table.width, tile_height = enlarged * table.height;
    const int tiles = table.channels + 1;
    Preview preview{gap + tiles * (tile_width + gap), gap + table.layers * (tile_height + gap), {}};
    preview.rgb.assign(3 * static_cast<size_t>(preview.width) * static_cast<size_t>(preview.height),
                       background);
    for (int layer = 0; layer < table.layers; ++layer) {
        const auto ranges = ranges_of(table, layer);
        for (int tile = 0; tile < tiles; ++tile)
            for (int y = 0; y < tile_height; ++y)
                for (int x = 0; x < tile_width; ++x) {
                    const auto colour = colour_in_tile(
                        table.texel(x / enlarged, y / enlarged, layer), ranges, tile);
                    const int column = gap + tile * (tile_width + gap) + x;
                    const int row = gap + layer * (tile_height + gap) + y;
                    const size_t at =
                        3 * (static_cast<size_t>(row) * static_cast<size_t>(preview.width) +
                             static_cast<size_t>(column));
                    std::ranges::copy(colour, preview.rgb.begin() + static_cast<ptrdiff_t>(at));
                }
    }
    return preview;
}

}  // namespace splitsum
