#include "splitsum/texture/texture_asset.h"

#include <gtest/gtest.h>

namespace splitsum {
namespace {

// A different colour in every texel of every face: exact in a half, and nothing is symmetric.
Cubemap numbered_cubemap(int face_size, float first) {
    Cubemap cubemap(face_size);
    float i = 0;
    for (Vec3& texel : cubemap.texels) {
        texel = Vec3(first + i, 2 * i, 0.5f * i);
        ++i;
    }
    return cubemap;
}

TEST(TextureAsset, ReadsBackTheCubemapsItWasMadeOf) {
    const std::vector<Cubemap> levels = {numbered_cubemap(6, 1), numbered_cubemap(3, 2),
                                         numbered_cubemap(1, 3)};
    std::vector<EncodeCounts> counts;
    const TextureAsset texture = texture_from_cubemaps(levels, PixelFormat::rgba16f, counts);
    EXPECT_EQ(texture.width, 6);
    EXPECT_EQ(texture.height, 6);
    EXPECT_EQ(texture.face_count, 6);
    EXPECT_EQ(counts.size(), 3u);
    EXPECT_TRUE(validate(texture));

    const auto back = cubemaps_of(texture);
    ASSERT_TRUE(back);
    ASSERT_EQ(back->size(), 3u);
    for (size_t level = 0; level < 3; ++level) {
        EXPECT_EQ((*back)[level].face_size, levels[level].face_size);
        EXPECT_EQ((*back)[level].texels, levels[level].texels);
    }
}

TEST(TextureAsset, CountsWhatDidNotFitLevelByLevel) {
    std::vector<Cubemap> levels = {numbered_cubemap(2, 1), numbered_cubemap(1, 1)};
    levels[0].at(3, 1, 0).y = 1e6f;
    levels[1].at(2, 0, 0).x = -1;
    levels[1].at(5, 0, 0).z = 65408.5f;
    std::vector<EncodeCounts> counts(1);  // of an earlier texture
    static_cast<void>(texture_from_cubemaps(levels, PixelFormat::rgb9e5, counts));
    ASSERT_EQ(counts.size(), 3u);
    EXPECT_EQ(counts[1].saturated, 1);
    EXPECT_EQ(counts[1].negative, 0);
    EXPECT_EQ(counts[2].saturated, 1);
    EXPECT_EQ(counts[2].negative, 1);
}

TEST(TextureAsset, ReadsBackTheTableItWasMadeOf) {
    for (const PixelFormatInfo& info : pixel_formats())
        for (const int layers : {1, 3}) {
            if (!holds_tables(info)) continue;
            Table table = blank_table(3, 2, info.channels, layers);
            float next = 0;
            for (float& value : table.values) value = next, next += 0.0625F / 8;
            EncodeCounts counts;
            const TextureAsset texture = texture_from_table(table, info.format, counts);
            EXPECT_TRUE(validate(texture));
            EXPECT_EQ(texture.layer_count, layers);
            const auto back = table_of(texture);
            ASSERT_TRUE(back);
            EXPECT_EQ(back->width, 3);
            EXPECT_EQ(back->height, 2);
            EXPECT_EQ(back->layers, layers);
            for (size_t i = 0; i < table.values.size(); ++i)
                EXPECT_NEAR(back->values[i], table.values[i], 1e-5F) << info.name;
        }
}

TEST(TextureAsset, RefusesTheOtherKind) {
    EncodeCounts count;
    std::vector<EncodeCounts> counts;
    const auto table = texture_from_table({1, 1, 2, 1, {1, 2}}, PixelFormat::rg16f, count);
    const std::vector<Cubemap> levels = {numbered_cubemap(1, 1)};
    const auto cube = texture_from_cubemaps(levels, PixelFormat::b10g11r11, counts);
    ASSERT_FALSE(cubemaps_of(table));
    EXPECT_EQ(cubemaps_of(table).error().kind, ErrorKind::unusable_input);
    EXPECT_NE(cubemaps_of(table).error().message.find("rg16f"), std::string::npos);
    ASSERT_FALSE(table_of(cube));
    EXPECT_EQ(table_of(cube).error().kind, ErrorKind::unusable_input);
}

TEST(TextureAsset, ValidateNoticesEachBrokenPromise) {
    const std::vector<Cubemap> levels = {numbered_cubemap(2, 1), numbered_cubemap(1, 1)};
    std::vector<EncodeCounts> counts;
    const TextureAsset good = texture_from_cubemaps(levels, PixelFormat::rgba16f, counts);
    const auto broken = [&](auto change) {
        TextureAsset texture = good;
        change(texture);
        const Status status = validate(texture);
        return !status && status.error().kind == ErrorKind::bad_argument;
    };
    ASSERT_TRUE(validate(good));
    EXPECT_TRUE(broken([](TextureAsset& t) { t.width = 0; }));
    EXPECT_TRUE(broken([](TextureAsset& t) { t.height = 1; }));
    EXPECT_TRUE(broken([](TextureAsset& t) { t.face_count = 5; }));
    EXPECT_TRUE(broken([](TextureAsset& t) { t.layer_count = 2; }));
    EXPECT_TRUE(broken([](TextureAsset& t) { t.layer_count = 0; }));
    EXPECT_TRUE(broken([](TextureAsset& t) { t.levels.clear(); }));
    EXPECT_TRUE(broken([](TextureAsset& t) { t.levels.push_back(t.levels.back()); }));
    EXPECT_TRUE(broken([](TextureAsset& t) { t.levels[1].pop_back(); }));
    EXPECT_TRUE(broken([](TextureAsset& t) { t.format = PixelFormat::rgba32f; }));
}

}  // namespace
}  // namespace splitsum
