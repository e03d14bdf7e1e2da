#include "splitsum/preview/view_lut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "splitsum/base/random.h"

namespace splitsum {
namespace {

View view_named(const char* name) {
    auto view = View::find(name, {});
    EXPECT_TRUE(view);
    return std::move(*view);
}

Vec3d shown_by(const View& view, const Vec3d& linear) {
    float rgb[3] = {float(linear.x), float(linear.y), float(linear.z)};
    view.apply(rgb);
    return {rgb[0], rgb[1], rgb[2]};
}

// Of every saturation, from 2^-10 to 2^5.
Vec3d some_color(uint32_t key) {
    const auto share = [key](uint32_t c) { return double(unit_float(8 * key + c)); };
    const double saturation = share(3);
    const Vec3d hue(1 - saturation * share(0), 1 - saturation * share(1),
                    1 - saturation * share(2));
    return std::exp2(15 * share(4) - 10) * hue;
}

TEST(ViewLut, IsTheViewOfAces) {
    const View view = view_named("aces");
    const ViewLut lut = view_lut_of(view);
    ASSERT_EQ(lut.rgb10.size(), size_t(lut.size) * size_t(lut.size) * size_t(lut.size));
    std::vector<double> off;
    for (uint32_t key = 0; key < 20000; ++key) {
        const Vec3d difference =
            255.0 * abs(look_up(lut, some_color(key)) - shown_by(view, some_color(key)));
        off.insert(off.end(), {difference.x, difference.y, difference.z});
    }
    double mean = 0;
    for (const double each : off) mean += each / double(off.size());
    std::ranges::sort(off);
    // Measured: 0.13, 0.58 and 8.9.
    EXPECT_LT(mean, 0.2);
    EXPECT_LT(off[off.size() * 99 / 100], 0.9);
    EXPECT_LT(off.back(), 13);
}

// Red, green and blue keep their places, and the texels theirs.
TEST(ViewLut, IsExactAtTexels) {
    const View view = view_named("aces");
    for (const int size : {2, 5, 16}) {
        const ViewLut lut = view_lut_of(view, size);
        const double range = std::log2(1 + ViewLut::steepness * ViewLut::brightest);
        const auto value = [&](int texel) {
            return (std::exp2(range * texel / (size - 1)) - 1) / ViewLut::steepness;
        };
        for (int texel = 0; texel < size; ++texel) {
            const Vec3d linear(value(texel), value(0), value(size - 1 - texel));
            EXPECT_LT(length(look_up(lut, linear) - shown_by(view, linear)), 2e-3) << size;
        }
    }
}

TEST(ViewLut, ClampsWhatIsOutside) {
    const ViewLut lut = view_lut_of(view_named("srgb"), 8);
    EXPECT_EQ(look_up(lut, Vec3d(-1, 1e30, 0)), look_up(lut, Vec3d(0, 64, 0)));
    EXPECT_EQ(look_up(lut, Vec3d(1e9)), Vec3d(1));
    EXPECT_EQ(look_up(lut, Vec3d(0)), Vec3d(0));
}

}  // namespace
}  // namespace splitsum
