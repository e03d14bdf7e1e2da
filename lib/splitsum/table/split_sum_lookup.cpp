#include "splitsum/table/split_sum_lookup.h"

#include <array>

#include "splitsum/table/bilinear.h"

namespace splitsum {

SplitSum look_up(const Table& table, double n_dot_v, double perceptual_roughness) {
    std::array<double, 2> read{};
    read_bilinear(
        table,
        texture_coordinates({}, table.width, ViewAxis::cosine, n_dot_v, perceptual_roughness),
        read);
    return {read[0], read[1]};
}

}  // namespace splitsum
