#include "splitsum/png/write_png.h"

#include <gtest/gtest.h>
#include <png.h>

#include <vector>

namespace splitsum {
namespace {

TEST(WritePng, ComesBackAsItWas) {
    std::vector<uint8_t> rgb;
    for (int i = 0; i < 3 * 5 * 3; ++i) rgb.push_back(static_cast<uint8_t>(7 * i));
    const auto path = std::filesystem::path(testing::TempDir()) / "picture.png";
    ASSERT_TRUE(write_png(path, 5, 3, rgb));
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    ASSERT_TRUE(png_image_begin_read_from_file(&image, path.c_str()));
    EXPECT_EQ(image.width, 5u);
    EXPECT_EQ(image.height, 3u);
    image.format = PNG_FORMAT_RGB;
    std::vector<uint8_t> back(PNG_IMAGE_SIZE(image));
    ASSERT_TRUE(png_image_finish_read(&image, nullptr, back.data(), 0, nullptr));
    EXPECT_EQ(back, rgb);
}

TEST(WritePng, AMissingFolderIsUnwritable) {
    const Status status = write_png("no/such/folder/x.png", 1, 1, std::vector<uint8_t>(3));
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().kind, ErrorKind::unwritable_output);
}

}  // namespace
}  // namespace splitsum
