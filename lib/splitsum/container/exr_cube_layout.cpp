#include <algorithm>
#include <cstring>

#include "splitsum/container/exr_cube_layout_detail.h"

namespace splitsum::exr {
namespace {

// `texels` is made of new_width x new_height equal blocks; each becomes its mean.
std::vector<float> box_averaged(const std::vector<float>& texels, int width, int height,
                                int new_width, int new_height) {
    const int block_width = width / new_width, block_height = height / new_height;
    const float weight = 1.0f / static_cast<float>(block_width * block_height);
    std::vector<float> means(3 * static_cast<size_t>(new_width) * static_cast<size_t>(new_height));
    const auto index = [](size_t x, size_t y, int row_width) {
        return 3 * (y * static_cast<size_t>(row_width) + x);
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float* from = &texels[index(x, y, width)];
            float* to = &means[index(x / block_width, y / block_height, new_width)];
            for (int c = 0; c < 3; ++c) to[c] += weight * from[c];  // weighed first: no overflow
        }
    return means;
}

StackLevel next_level(const StackLevel& level, PixelFormat format) {
    const size_t stride = static_cast<size_t>(info_of(format).bytes_per_texel);
    std::vector<float> texels(3 * level.texels.size() / stride);
    decode_texels(format, 3, level.texels, texels);
    StackLevel next{std::max(1, level.width / 2), std::max(1, level.height / 2), {}};
    const auto means = box_averaged(texels, level.width, level.height, next.width, next.height);
    next.texels.resize(means.size() / 3 * stride);
    encode_texels(format, 3, means, next.texels);
    return next;
}

}  // namespace

std::vector<std::byte> turned_faces(std::span<const std::byte> level, int face_size,
                                    size_t bytes_per_texel) {
    const auto size = static_cast<size_t>(face_size);
    std::vector<std::byte> turned(level.size());
    const auto row_at = [&](size_t face, size_t y) { return (face * size + y) * size; };
    for (size_t face = 0; face < 6; ++face) {
        const bool upside_down = face == 2 || face == 3;
        for (size_t y = 0; y < size; ++y) {
            const std::byte* from = level.data() + row_at(face, y) * bytes_per_texel;
            const size_t to_y = upside_down ? size - 1 - y : y;
            std::byte* to = turned.data() + row_at(face, to_y) * bytes_per_texel;
            for (size_t x = 0; x < size; ++x) {
                const size_t to_x = upside_down ? x : size - 1 - x;
                std::memcpy(to + to_x * bytes_per_texel, from + x * bytes_per_texel,
                            bytes_per_texel);
            }
        }
    }
    return turned;
}

std::vector<StackLevel> stack_levels(const TextureAsset& texture) {
    const auto stride = static_cast<size_t>(info_of(texture.format).bytes_per_texel);
    std::vector<StackLevel> stack;
    for (const auto& level : texture.levels) {
        const int face_size = std::max(1, texture.width >> stack.size());
        stack.push_back({face_size, 6 * face_size, turned_faces(level, face_size, stride)});
    }
    if (stack.size() == 1) return stack;
    while (stack.back().height > 1) stack.push_back(next_level(stack.back(), texture.format));
    return stack;
}

}  // namespace splitsum::exr
