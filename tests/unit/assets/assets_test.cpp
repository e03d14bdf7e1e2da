#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "splitsum/assets/cubemap_asset.h"
#include "splitsum/assets/table_asset.h"
#include "splitsum/table/split_sum_exact.h"

namespace splitsum {
namespace {

std::vector<Cubemap> chain() {
    std::vector<Cubemap> levels = {Cubemap(4), Cubemap(2)};
    float value = 0.1f;
    for (Cubemap& level : levels)
        for (Vec3& texel : level.texels) texel = Vec3(value, 2 * value, 3 * value), value *= 1.07f;
    return levels;
}

TEST(CubemapAsset, HoldsWhatAnEngineReadsBack) {
    for (const PixelFormatInfo& format : pixel_formats()) {
        const auto asset = cubemap_asset(chain(), format.format, {});
        if (format.channels != 3) {
            ASSERT_FALSE(asset);
            EXPECT_EQ(asset.error().kind, ErrorKind::bad_argument);
            continue;
        }
        ASSERT_TRUE(asset);
        EXPECT_EQ(asset->texture.format, format.format);
        EXPECT_EQ(asset->texture.metadata, metadata_of({}));
        ASSERT_EQ(asset->levels.size(), 2u);
        const auto decoded = cubemaps_of(asset->texture);
        for (size_t level = 0; level < 2; ++level) {
            EXPECT_EQ(asset->levels[level].texels, (*decoded)[level].texels) << format.name;
            for (size_t i = 0; i < asset->levels[level].texels.size(); ++i)
                EXPECT_LT(length(asset->levels[level].texels[i] - chain()[level].texels[i]),
                          0.02f * length(chain()[level].texels[i]))
                    << format.name;
        }
    }
}

TEST(CubemapAsset, CountsWhatDidNotFitLevelByLevel) {
    for (const PixelFormatInfo& format : pixel_formats()) {
        if (format.channels != 3) continue;
        auto levels = chain();
        levels[0].at(1, 2, 3) = Vec3(1e5f, 1, 2e5f);
        levels[1].at(5, 0, 1) = Vec3(0, 1e6f, 0);
        const auto asset = cubemap_asset(levels, format.format, {});
        ASSERT_EQ(asset->counts.size(), 2u);
        const bool holds = format.largest[0] > 1e6f;
        EXPECT_EQ(asset->counts[0].saturated, holds ? 0 : 2) << format.name;
        EXPECT_EQ(asset->counts[1].saturated, holds ? 0 : 1) << format.name;
        EXPECT_EQ(asset->levels[0].at(1, 2, 3).z, holds ? 2e5f : format.largest[2]) << format.name;
    }
}

// The largest error of the stored table over all of its texels.
double worst_of(const TextureAsset& texture) {
    const auto table = table_of(texture);
    double worst = 0;
    for (int y = 0; y < table->height; ++y)
        for (int x = 0; x < table->width; ++x) {
            const double r = (y + 0.5) / table->height;
            const SplitSum exact =
                split_sum_exact(SmithTerm::height_correlated, (x + 0.5) / table->width, r * r);
            const Vec2 stored = table->texels[size_t(y) * size_t(table->width) + size_t(x)];
            worst = std::max({worst, std::abs(double(stored.x) - exact.a),
                              std::abs(double(stored.y) - exact.b)});
        }
    return worst;
}

TEST(TableAsset, MeasuresWhatIsStored) {
    NoProgress progress;
    for (const int size : {1, 2, 9, 24})
        for (const PixelFormat format : {PixelFormat::rg16f, PixelFormat::rg32f}) {
            const auto asset = bake_table({.size = size}, format, progress);
            ASSERT_TRUE(asset);
            EXPECT_GT(asset->probes, 64);
            const double worst = worst_of(asset->texture);
            EXPECT_LE(asset->max_abs, worst * (1 + 1e-12)) << size;
            EXPECT_GE(asset->max_abs, 0.7 * worst) << size;  // the probes find what counts
            EXPECT_LT(worst, 2e-3) << size;                  // 1.06e-3 with 1024 points a texel
        }
}

TEST(TableAsset, NoticesATableOfTooFewSamples) {
    NoProgress progress;
    EXPECT_GT(bake_table({.size = 16, .samples = 1}, PixelFormat::rg32f, progress)->max_abs, 1e-2);
}

TEST(TableAsset, RowsArePerceptualRoughness) {
    NoProgress progress;
    const auto asset = bake_table({.size = 8}, PixelFormat::rg32f, progress);
    const auto table = table_of(asset->texture);
    const SplitSum exact = split_sum_exact(SmithTerm::height_correlated, 6.5 / 8, 0.1875 * 0.1875);
    EXPECT_NEAR(table->texels[1 * 8 + 6].x, exact.a, 2e-3);
    EXPECT_NEAR(table->texels[1 * 8 + 6].y, exact.b, 2e-3);
    EXPECT_EQ(asset->texture.metadata.at("splitsum.geometry"), "height-correlated");
}

}  // namespace
}  // namespace splitsum
