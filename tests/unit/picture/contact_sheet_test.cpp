#include "splitsum/picture/contact_sheet.h"

#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "splitsum/base/parallel.h"
#include "splitsum/image/image.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

// Red towards +x, green up, blue towards +z, over a little grey.
Cubemap lopsided(int size, float factor = 1) {
    Cubemap cubemap(size);
    for (int face = 0; face < face_count; ++face)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const Vec3d d = direction_of_texel(face, x, y, size);
                cubemap.at(face, x, y) =
                    factor * (Vec3(0.05f) +
                              Vec3(std::max(d.x, 0.0), std::max(d.y, 0.0), std::max(d.z, 0.0)));
            }
    return cubemap;
}

Image read(const fs::path& path) {
    png_image file{};
    file.version = PNG_IMAGE_VERSION;
    EXPECT_TRUE(png_image_begin_read_from_file(&file, path.c_str())) << file.message;
    file.format = PNG_FORMAT_RGB;
    std::vector<uint8_t> bytes(PNG_IMAGE_SIZE(file));
    EXPECT_TRUE(png_image_finish_read(&file, nullptr, bytes.data(), 0, nullptr)) << file.message;
    Image image;
    image.width = static_cast<int>(file.width);
    image.height = static_cast<int>(file.height);
    for (const uint8_t value : bytes) image.rgb.push_back(static_cast<float>(value) / 255);
    return image;
}

std::string bytes_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

fs::path picture_of(const ContactSheet& sheet, const std::string& name) {
    const fs::path path = fs::path(testing::TempDir()) / name;
    const Status written = write_contact_sheet(sheet, path);
    EXPECT_TRUE(written) << written.error().message;
    return path;
}

TEST(ContactSheet, TwiceTheLightIsOneStopLess) {
    const Cubemap map = lopsided(16), brighter = lopsided(16, 2);
    const ContactSheet one{{{&map, 0}}, nullptr}, two{{{&brighter, 0}}, nullptr};
    EXPECT_NEAR(exposure_stops_of(two), exposure_stops_of(one) - 1, 1e-6);
    EXPECT_EQ(bytes_of(picture_of(one, "one.png")), bytes_of(picture_of(two, "two.png")));
}

TEST(ContactSheet, AConstantIsShownAtItsKey) {
    Cubemap grey(4);
    for (Vec3& texel : grey.texels) texel = Vec3(0.5f);
    EXPECT_NEAR(exposure_stops_of({{{&grey, 0}}, nullptr}), -1, 1e-6);
    const Cubemap black(4);
    EXPECT_EQ(exposure_stops_of({{{&black, 0}}, nullptr}), 0);
    EXPECT_EQ(exposure_stops_of({}), 0);
}

TEST(ContactSheet, ShowsDirectionsWhereTheyBelong) {
    const Cubemap map = lopsided(32);
    const Image picture = read(picture_of({{{&map, 0.5}}, nullptr}, "where.png"));
    ASSERT_EQ(picture.width, 1600);
    // One cell of 520 pixels in the middle: a ball, half a gap of 24, a strip of 260 pixels.
    const auto at = [&](int x, int y) {
        return picture.row(y).subspan(3 * static_cast<size_t>(540 + x), 3);
    };
    const int ball = 24, strip = 24 + 520 + 12;
    EXPECT_GT(at(390, strip + 130)[0], at(130, strip + 130)[0] + 0.3f);  // +x to the right
    EXPECT_GT(at(260, strip + 130)[2], at(260, strip + 130)[0] + 0.3f);  // +z in the middle
    EXPECT_GT(at(260, strip + 5)[1], at(260, strip + 254)[1] + 0.3f);    // +y on top
    EXPECT_GT(at(260, ball + 260)[2], at(260, ball + 260)[1] + 0.3f);    // the ball mirrors +z
    EXPECT_GT(at(430, ball + 260)[0], at(90, ball + 260)[0] + 0.3f);
    EXPECT_GT(at(260, ball + 80)[1], at(260, ball + 440)[1] + 0.3f);
    const int bar = strip + 260 + 12 + 3;
    EXPECT_GT(at(255, bar)[0], at(265, bar)[0] + 0.3f);  // half full
}

TEST(ContactSheet, HoldsAnyNumberOfCells) {
    const Cubemap map = lopsided(2);
    for (const size_t levels : {0, 1, 5, 7, 8, 12}) {
        const ContactSheet sheet{std::vector(levels, ContactSheet::Level{&map, 1}), &map};
        const Image picture = read(picture_of(sheet, "many.png"));
        EXPECT_EQ(picture.width, 1600);
        EXPECT_GT(picture.height, 300);
        EXPECT_LT(picture.height, 2200);
    }
}

TEST(ContactSheet, GivesTheSameBytesForAnyNumberOfThreads) {
    const Cubemap map = lopsided(8);
    const auto bytes = [&](int threads) {
        const ThreadLimit limit(threads);
        return bytes_of(picture_of({{{&map, 0.5}}, &map}, "threads.png"));
    };
    EXPECT_EQ(bytes(1), bytes(4));
}

TEST(ContactSheet, NamesWhatIsWrong) {
    const Status nothing = write_contact_sheet({}, fs::path(testing::TempDir()) / "nothing.png");
    ASSERT_FALSE(nothing);
    EXPECT_EQ(nothing.error().kind, ErrorKind::bad_argument);
    const Cubemap map = lopsided(2);
    const Status nowhere = write_contact_sheet({{}, &map}, "no/such/folder/a.png");
    ASSERT_FALSE(nowhere);
    EXPECT_EQ(nowhere.error().kind, ErrorKind::unwritable_output);
}

}  // namespace
}  // namespace splitsum
