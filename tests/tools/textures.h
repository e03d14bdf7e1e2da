#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "splitsum/container/containers.h"
#include "splitsum/texture/texture_asset.h"

namespace splitsum::tests {

/// The levels of a cubemap file as an engine reads them; a failure of the test where it cannot.
inline std::vector<Cubemap> levels_in(const std::filesystem::path& path) {
    const auto texture = read_texture(path);
    if (!texture) {
        ADD_FAILURE() << texture.error().message;
        return {};
    }
    const auto levels = cubemaps_of(*texture);
    EXPECT_TRUE(levels) << path;
    return levels ? *levels : std::vector<Cubemap>{};
}

/// Writes a portable float map of 2 `height` by `height` pixels whose colour is color(u, v) in the
/// middle of each; u and v run from 0 to 1, right and down. Such a file needs no library at all.
template <class Color>
void write_panorama(const std::filesystem::path& path, int height, const Color& color) {
    std::ofstream file(path, std::ios::binary);
    file << "PF\n" << 2 * height << " " << height << "\n-1.0\n";  // negative: little-endian
    for (int y = height - 1; y >= 0; --y)                         // the bottom row comes first
        for (int x = 0; x < 2 * height; ++x) {
            const Vec3 rgb = color((x + 0.5) / (2 * height), (y + 0.5) / height);
            for (int c = 0; c < 3; ++c)
                file.write(reinterpret_cast<const char*>(&rgb[c]), sizeof(float));
        }
}

}  // namespace splitsum::tests
