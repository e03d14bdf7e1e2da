#pragma once

#include <vector>

#include "splitsum/math/vec.h"

namespace splitsum {

/// Two channels over a 2D grid, row by row: the split-sum table.
struct Table {
    int width = 0;
    int height = 0;
    std::vector<Vec2> texels;
};

}  // namespace splitsum
