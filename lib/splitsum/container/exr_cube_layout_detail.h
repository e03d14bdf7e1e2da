#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "splitsum/texture/texture_asset.h"

namespace splitsum::exr {

/// The texels of one level moved between the KTX layout and OpenEXR's, which is its own inverse.
/// In both, the faces +X -X +Y -Y +Z -Z follow each other; OpenEXR's (ImfEnvmap.h, the drawing of
/// CubeMap) are mirrored: the four sides left to right, +Y and -Y top to bottom.
std::vector<std::byte> turned_faces(std::span<const std::byte> level, int face_size,
                                    size_t bytes_per_texel);

/// A level of the stack of faces as MIP levels count it.
struct StackLevel {
    int width;
    int height;
    std::vector<std::byte> texels;  ///< in OpenEXR's layout
};

/// All the levels that MIP levels of a stack of `texture.width` x 6 `texture.width` texels have:
/// the texture's own, then box averages of its last one down to 1x1. `texture.width` is a power of
/// two when the texture has several levels; with one level there is nothing to add.
std::vector<StackLevel> stack_levels(const TextureAsset& texture);

}  // namespace splitsum::exr
