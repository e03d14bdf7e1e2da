#include "splitsum/preview/view_lut.h"

#include <algorithm>
#include <cmath>

#include "splitsum/base/parallel.h"

namespace splitsum {
namespace {

constexpr int levels_of_channel = 1023;

const double whole_range = std::log2(1 + ViewLut::steepness * ViewLut::brightest);

double linear_of(int texel, int size) {
    return (std::exp2(whole_range * texel / (size - 1)) - 1) / ViewLut::steepness;
}

// In texels, from the centre of the first one.
double place_of(double linear, int size) {
    const double clamped = std::clamp(linear, 0.0, ViewLut::brightest);
    return std::log2(1 + ViewLut::steepness * clamped) / whole_range * (size - 1);
}

uint32_t packed(std::span<const float, 3> rgb) {
    uint32_t bits = 0;
    for (size_t c = 0; c < 3; ++c)
        bits |= uint32_t(std::lround(levels_of_channel * rgb[c])) << (10 * c);
    return bits;
}

Vec3d unpacked(uint32_t bits) {
    return Vec3d(bits & 1023, bits >> 10 & 1023, bits >> 20 & 1023) / double(levels_of_channel);
}

}  // namespace

ViewLut view_lut_of(const View& view, int size) {
    const size_t row_size = size_t(size) * size_t(size);
    ViewLut lut{size, std::vector<uint32_t>(row_size * size_t(size))};
    parallel_rows(size, [&](int blue) {
        std::vector<float> rgb(3 * row_size);
        for (size_t i = 0; i < row_size; ++i) {
            rgb[3 * i] = float(linear_of(int(i) % size, size));
            rgb[3 * i + 1] = float(linear_of(int(i) / size, size));
            rgb[3 * i + 2] = float(linear_of(blue, size));
        }
        view.apply(rgb);
        for (size_t i = 0; i < row_size; ++i)
            lut.rgb10[row_size * size_t(blue) + i] =
                packed(std::span<const float, 3>(rgb.data() + 3 * i, 3));
    });
    return lut;
}

Vec3d look_up(const ViewLut& lut, const Vec3d& linear) {
    int low[3];
    double share[3];
    for (int c = 0; c < 3; ++c) {
        const double place = place_of(linear[c], lut.size);
        low[c] = std::min(int(place), lut.size - 2);
        share[c] = place - low[c];
    }
    Vec3d sum(0);
    for (int corner = 0; corner < 8; ++corner) {
        double weight = 1;
        int index = 0;
        for (int c = 2; c >= 0; --c) {
            const int high = corner >> c & 1;
            weight *= high ? share[c] : 1 - share[c];
            index = index * lut.size + low[c] + high;
        }
        sum += weight * unpacked(lut.rgb10[size_t(index)]);
    }
    return sum;
}

}  // namespace splitsum
