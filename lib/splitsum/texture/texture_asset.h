#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "splitsum/base/result.h"
#include "splitsum/image/table.h"
#include "splitsum/sphere/cubemap.h"
#include "splitsum/texture/pixel_format.h"

namespace splitsum {

/// A texture as a container stores it, whichever container that is: encoded texels and the
/// conventions that tell what a lookup means.
struct TextureAsset {
    PixelFormat format = PixelFormat::rgba16f;
    int width = 0;  ///< of level 0, in texels
    int height = 0;
    int face_count = 1;   ///< 1, or 6 for a cubemap (width = height)
    int layer_count = 1;  ///< above 1: a 2D array, which has one face
    /// levels[l]: the texels of mip level l, layer or face by face, row by row, without padding; level l is
    /// max(1, width >> l) wide.
    std::vector<std::vector<std::byte>> levels;
    /// Conventions and provenance under "splitsum.*" and the container's own keys, as text.
    std::map<std::string, std::string> metadata;
};

/// A cubemap before it is made.
struct CubeShape {
    PixelFormat format;
    int face_size;
    int levels;
};

/// How many bytes `levels[level]` of a texture with that format, size and number of faces holds.
size_t bytes_of_level(const TextureAsset& texture, int level);

/// How many levels a texture of that size can have: the last one is 1 texel wide and high.
int full_level_count(int width, int height);

/// Whether the texture keeps what its fields promise: a positive size, 1 or 6 faces, square faces of
/// a cube, at least one layer and of a cube no more, at least one level and no more than full_level_count, each of bytes_of_level bytes. Fails
/// with bad_argument.
Status validate(const TextureAsset& texture);

/// The levels as a cubemap texture. Level l must have max(1, levels[0].face_size >> l) texels along
/// its edge; `format` must hold colours. Adds what did not fit to `counts`, one entry a level.
TextureAsset texture_from_cubemaps(std::span<const Cubemap> levels, PixelFormat format,
                                   std::vector<EncodeCounts>& counts);

/// The table as a 2D texture, an array if it has several layers; `format` must hold tables and store
/// no fewer channels than the table has.
TextureAsset texture_from_table(const Table& table, PixelFormat format, EncodeCounts& counts);

/// What an engine reads back: the levels as floats. Fails with unusable_input for a texture that is
/// not a cubemap of colours.
Result<std::vector<Cubemap>> cubemaps_of(const TextureAsset& texture);

/// What an engine reads back: the table as floats, with all channels that the format stores. Fails with unusable_input for other textures.
Result<Table> table_of(const TextureAsset& texture);

}  // namespace splitsum
