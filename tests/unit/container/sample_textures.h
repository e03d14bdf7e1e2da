#pragma once

#include <algorithm>
#include <vector>

#include "splitsum/texture/texture_asset.h"

namespace splitsum {

// Textures whose every texel says where it is, in small whole numbers that all formats hold exactly:
// a swapped face, row, channel or level changes them.

/// (face + 1, x + 1, y + 1 + 16 level).
inline Cubemap sample_level(int face_size, int level) {
    Cubemap cubemap(face_size);
    for (int face = 0; face < face_count; ++face)
        for (int y = 0; y < face_size; ++y)
            for (int x = 0; x < face_size; ++x)
                cubemap.at(face, x, y) = Vec3(face + 1, x + 1, y + 1 + 16 * level);
    return cubemap;
}

inline TextureAsset sample_cube(PixelFormat format, int face_size = 8, int level_count = 4) {
    std::vector<Cubemap> levels;
    for (int level = 0; level < level_count; ++level)
        levels.push_back(sample_level(std::max(1, face_size >> level), level));
    std::vector<EncodeCounts> counts;
    TextureAsset texture = texture_from_cubemaps(levels, format, counts);
    texture.metadata = {{"splitsum.convention", "ktx"},
                        {"splitsum.roughness", "0 0.25 0.5 1"},
                        {"splitsum.source", "a sky named \xc3\xa9t\xc3\xa9"},
                        {"splitsum.empty", ""}};
    return texture;
}

/// (x + 1, 10 (y + 1), layer + 1, 7) cut to `channels`, 5 x 3 texels; sixty-fourths of it for formats
/// that end at 1.
inline TextureAsset sample_table(PixelFormat format, int channels = 2, int layers = 1) {
    Table table = blank_table(5, 3, channels, layers);
    const float unit = info_of(format).largest[0] > 1 ? 1.0F : 1.0F / 64;
    for (int layer = 0; layer < layers; ++layer)
        for (int y = 0; y < table.height; ++y)
            for (int x = 0; x < table.width; ++x) {
                const int texel[] = {x + 1, 10 * (y + 1), layer + 1, 7};
                for (int c = 0; c < channels; ++c)
                    table.texel(x, y, layer)[size_t(c)] = unit * float(texel[c]);
            }
    EncodeCounts counts;
    TextureAsset texture = texture_from_table(table, format, counts);
    texture.metadata = {{"splitsum.table", "split sum"}};
    return texture;
}

inline bool same_texels(const TextureAsset& a, const TextureAsset& b) {
    return a.format == b.format && a.width == b.width && a.height == b.height &&
           a.face_count == b.face_count && a.layer_count == b.layer_count && a.levels == b.levels;
}

}  // namespace splitsum
