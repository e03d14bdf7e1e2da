#include "splitsum/preview/page_texels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "splitsum/base/base64.h"
#include "splitsum/texture/texture_asset.h"

namespace splitsum {
namespace {

// A lopsided chain of 4² and 2², no two texels alike.
std::vector<Cubemap> chain() {
    std::vector<Cubemap> levels = {Cubemap(4), Cubemap(2)};
    for (Cubemap& level : levels)
        for (int face = 0; face < face_count; ++face)
            for (int y = 0; y < level.face_size; ++y)
                for (int x = 0; x < level.face_size; ++x) {
                    const Vec3d d = direction_of_texel(face, x, y, level.face_size);
                    level.at(face, x, y) = Vec3(std::exp(3 * d.x), 1.1 + d.y, 700 * (2 + d.z));
                }
    return levels;
}

std::string text_of(std::span<const std::byte> bytes) {
    return base64({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

// Stored, and read back by an engine: the page carries the very bytes.
void expect_as_stored(PixelFormat stored, std::string_view expected_format) {
    std::vector<EncodeCounts> counts(2);
    const TextureAsset texture = texture_from_cubemaps(chain(), stored, counts);
    const auto read = cubemaps_of(texture);
    ASSERT_TRUE(read);
    const PageTexels texels = page_texels(*read);
    EXPECT_EQ(texels.format, expected_format);
    EXPECT_TRUE(texels.exact);
    std::vector<std::byte> bytes;
    for (const auto& level : texture.levels)
        for (size_t i = 0; i < level.size(); ++i)
            if (stored != PixelFormat::rgba16f || i % 8 < 6) bytes.push_back(level[i]);
    EXPECT_EQ(texels.base64, text_of(bytes));
}

TEST(PageTexels, AreTheStoredBytes) {
    expect_as_stored(PixelFormat::rgb9e5, "rgb9e5");
    expect_as_stored(PixelFormat::b10g11r11, "b10g11r11");
    expect_as_stored(PixelFormat::rgba16f, "rgb16f");
}

TEST(PageTexels, SayWhereFloatsWereRounded) {
    const PageTexels floats = page_texels(chain());
    EXPECT_EQ(floats.format, "rgb16f");
    EXPECT_FALSE(floats.exact);
    Cubemap bright(1);
    bright.texels.assign(6, Vec3(1e9f));
    EXPECT_FALSE(page_texels(std::span(&bright, 1)).exact);
    // 65504 and nothing else.
    EXPECT_EQ(page_texels(std::span(&bright, 1)).base64.substr(0, 8), "/3v/e/97");
}

TEST(PageTexels, OfATableAreAAndB) {
    Table table = blank_table(2, 1, 4);
    table.values = {1, 0.5f, 9, 9, 0.25f, 0, 9, 9};
    EXPECT_EQ(page_texels(table).format, "rg16f");
    // 0x3c00 0x3800 0x3400 0x0000, the low byte first.
    EXPECT_EQ(page_texels(table).base64, base64(std::string("\0\x3c\0\x38\0\x34\0\0", 8)));
}

TEST(PageTexels, OfAPictureAreItsRows) {
    Image picture(1, 2);
    picture.rgb = {1, 0.5f, 0.25f, 2, 0, 1};
    EXPECT_EQ(page_texels(picture).base64,
              base64(std::string("\0\x3c\0\x38\0\x34\0\x40\0\0\0\x3c", 12)));
}

}  // namespace
}  // namespace splitsum
