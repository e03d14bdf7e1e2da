#pragma once

#include <algorithm>
#include <bit>

namespace splitsum {

/// How many levels a chain of that size has in the chart: down to faces of 4², as the default of 256²
/// and 7 levels does, but at least two.
inline int usual_level_count(int face_size) {
    return std::max(2, int(std::bit_width(unsigned(face_size))) - 2);
}

}  // namespace splitsum
