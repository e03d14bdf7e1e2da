#pragma once

#include <vector>

#include "splitsum/base/random.h"
#include "splitsum/image/table.h"
#include "splitsum/sphere/cubemap.h"

namespace splitsum::tests {

/// Textures whose every number is one of its own in [0, 1): nothing is smooth, and no face, level or
/// layer is like another.
inline Cubemap noisy_cubemap(int size, uint32_t key) {
    Cubemap cubemap(size);
    for (Vec3& texel : cubemap.texels)
        for (int channel = 0; channel < 3; ++channel) texel[channel] = unit_float(key++);
    return cubemap;
}

/// Seven levels, 64 texels down to 1.
inline std::vector<Cubemap> noisy_levels() {
    std::vector<Cubemap> levels;
    for (int size = 64; size > 0; size /= 2)
        levels.push_back(noisy_cubemap(size, 1'000'000 * static_cast<uint32_t>(size)));
    return levels;
}

inline Table noisy_table(int size, int channels, int layers) {
    Table table = blank_table(size, size, channels, layers);
    for (uint32_t i = 0; i < table.values.size(); ++i) table.values[i] = unit_float(i);
    return table;
}

}  // namespace splitsum::tests
