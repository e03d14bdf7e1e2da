#pragma once

#include <cstddef>
#include <vector>

namespace splitsum {

/// Adds `size` bytes to the end of a file in memory.
inline void append(std::vector<std::byte>& file, const void* data, size_t size) {
    const auto* bytes = static_cast<const std::byte*>(data);
    file.insert(file.end(), bytes, bytes + size);
}

}  // namespace splitsum
