// Row 5: light above what a format holds is stored as the largest value, counted, and never Inf.
#include <algorithm>

#include "splitsum/assets/cubemap_asset.h"
#include "stability/levels.h"

namespace splitsum::tests {
namespace {

TEST(BrightLight, SaturatesAndIsCounted) {
    Environment sky(64);
    for (int x = 60; x < 63; ++x) sky.set_texel(x, 30, Vec3(3e5f, 2e5f, 1e5f));
    const Cubemap mirror = levels_by("reference", sky, {0}, 64)[0];
    for (const PixelFormatInfo& format : pixel_formats()) {
        if (!holds_colours(format)) continue;
        int64_t above = 0;
        float brightest = 0;
        for (const Vec3& texel : mirror.texels)
            for (int c = 0; c < 3; ++c) {
                above += texel[c] > format.largest[size_t(c)];
                brightest = std::max(brightest, texel[c]);
            }
        ASSERT_GT(brightest, 1e5f);
        const auto asset = cubemap_asset({&mirror, 1}, format.format, AssetFacts());
        ASSERT_TRUE(asset);
        EXPECT_EQ(asset->counts[0].saturated, above) << format.name;
        EXPECT_EQ(above == 0, format.name == "rgba32f") << format.name;
        expect_light(asset->levels[0]);
        for (int c = 0; c < 3; ++c) {
            float stored = 0;
            for (const Vec3& texel : asset->levels[0].texels) stored = std::max(stored, texel[c]);
            if (above > 0) {
                EXPECT_EQ(stored, format.largest[size_t(c)]) << format.name;
            }
        }
    }
}

}  // namespace
}  // namespace splitsum::tests
