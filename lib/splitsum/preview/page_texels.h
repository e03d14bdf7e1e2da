#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "splitsum/image/image.h"
#include "splitsum/image/table.h"
#include "splitsum/sphere/cubemap.h"

namespace splitsum {

/// Texels as a page carries them: what WebGL 2 takes and filters without extensions.
struct PageTexels {
    /// "rgb9e5", "b10g11r11": one 32-bit number a texel, as KTX 2 stores them. "rgb16f", "rg16f": half
    /// floats, as many as there are channels.
    std::string_view format;
    std::string
        base64;  ///< little-endian, as texture uploads take them: level 0 first, face by face
    bool exact = true;  ///< nothing was rounded: false where floats needed more than 11 bits
};

/// The levels in the smallest format that holds every texel exactly, so that a chain that was stored in
/// one of those formats travels as it was stored. Others, of 32-bit floats, become half floats: rounded
/// to 11 bits, and to 65504 above that.
PageTexels page_texels(std::span<const Cubemap> levels);

/// The first two channels of a table as half floats. It has one layer.
PageTexels page_texels(const Table& table);

/// A picture as half floats, row 0 first.
PageTexels page_texels(const Image& picture);

}  // namespace splitsum
