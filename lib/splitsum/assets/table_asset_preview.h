#pragma once

#include <cstdint>
#include <vector>

#include "splitsum/image/table.h"

namespace splitsum {

/// An 8-bit RGB picture, row by row.
struct Preview {
    int width = 0;
    int height = 0;
    std::vector<uint8_t> rgb;
};

/// A picture of a table for people: a row of tiles a layer, the first with the channels as red, green
/// and blue, then each channel in grey. A tile shows the texels as they are stored, row 0 on top,
/// enlarged by a whole factor where they are few. Grey is linear from the channel's least value or 0,
/// whichever is lower, to its largest or 1, whichever is higher.
Preview preview_of(const Table& table);

}  // namespace splitsum
