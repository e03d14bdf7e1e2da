#include "splitsum/imageio/image_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>

#include "splitsum/base/atomic_file.h"
#include "splitsum/png/write_png.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

const fs::path test_data = SPLITSUM_TEST_DATA;

// The image behind every file of test_data/reading, as test_data/make_test_data.cpp defines it.
float source_value(int x, int y, int channel) {
    if (channel == 0) return 0.5f + static_cast<float>(x) / 64;
    if (channel == 1) return 0.25f + static_cast<float>(y) / 64;
    return 0.125f + static_cast<float>((x * 5 + y * 3) % 64) / 128;
}

Result<Image> read_all(ImageReader& reader) {
    Image image;
    image.width = reader.info().width;
    image.height = reader.info().height;
    int expected_row = 0;
    const Status status =
        reader.read_rows([&](int first_row, int row_count, std::span<const float> rgb) -> Status {
            EXPECT_EQ(first_row, expected_row) << "rows must come from the top down";
            EXPECT_EQ(rgb.size(), 3u * static_cast<size_t>(row_count * image.width));
            image.rgb.insert(image.rgb.end(), rgb.begin(), rgb.end());
            expected_row += row_count;
            return ok;
        });
    if (!status) return status.error();
    EXPECT_EQ(expected_row, image.height);
    return image;
}

Result<Image> read_file(const fs::path& path, const std::string& layer = {}) {
    auto reader = ImageReader::open(path, layer);
    if (!reader) return reader.error();
    return read_all(*reader);
}

using Wanted = std::function<float(int x, int y, int channel)>;

void expect_pixels(const std::string& file, const Wanted& wanted, float tolerance = 0,
                   const std::string& layer = {}) {
    SCOPED_TRACE(file);
    const auto image = read_file(test_data / "reading" / file, layer);
    ASSERT_TRUE(image) << image.error().message;
    ASSERT_EQ(image->width, 32);
    ASSERT_EQ(image->height, 16);
    for (int y = 0; y < image->height; ++y)
        for (int x = 0; x < image->width; ++x)
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(image->row(y)[static_cast<size_t>(3 * x + c)], wanted(x, y, c),
                            tolerance)
                    << "x " << x << ", y " << y << ", channel " << c;
}

std::string notes_of(const std::string& file) {
    const auto reader = ImageReader::open(test_data / "reading" / file);
    if (!reader) return reader.error().message;
    std::string all;
    for (const std::string& note : reader->info().notes) all += note + "\n";
    return all;
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(ImageReader, ReadsEveryStorageAlike) {
    for (const char* file : {"half_zip.exr", "half_tiled.exr", "float.exr", "float.tif",
                             "float.pfm", "rgbe.hdr", "acescg.exr"})
        expect_pixels(file, source_value);
    expect_pixels("half_dwa.exr", source_value, 0.02f);
    expect_pixels("uint16.tif", source_value, 0.5f / 65535);
}

TEST(ImageReader, SetsAFileUpright) {
    expect_pixels("upside_down.hdr",
                  [](int x, int y, int c) { return source_value(x, 15 - y, c); });
    EXPECT_TRUE(contains(notes_of("upside_down.hdr"), "upright"));
}

TEST(ImageReader, ReadsLuminanceAsGrey) {
    for (const char* file : {"grey.exr", "grey_alpha.exr"}) {
        expect_pixels(file, [](int x, int y, int) { return source_value(x, y, 1); });
        EXPECT_TRUE(contains(notes_of(file), "grey"));
    }
}

TEST(ImageReader, DropsAlphaAndKeepsColoursAsStored) {
    expect_pixels("rgba.exr", source_value);
    EXPECT_TRUE(contains(notes_of("rgba.exr"), "alpha"));
}

TEST(ImageReader, IgnoresExtraChannelsWithANote) {
    expect_pixels("extra_channels.exr", source_value);
    EXPECT_TRUE(contains(notes_of("extra_channels.exr"), "Z, id.x"));
}

TEST(ImageReader, ChoosesALayer) {
    const auto turned = [](int x, int y, int c) { return source_value(x, y, (c + 2) % 3); };
    expect_pixels("one_layer.exr", source_value);
    expect_pixels("default_and_layer.exr", source_value);
    expect_pixels("default_and_layer.exr", turned, 0, "fill");
    expect_pixels("two_layers.exr", turned, 0, "fill");
    expect_pixels("two_layers.exr", source_value, 0, "key");

    const auto undecided = ImageReader::open(test_data / "reading/two_layers.exr");
    ASSERT_FALSE(undecided);
    EXPECT_EQ(undecided.error().kind, ErrorKind::unusable_input);
    EXPECT_TRUE(contains(undecided.error().message, "fill, key"));
    const auto unknown = ImageReader::open(test_data / "reading/two_layers.exr", "rim");
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().kind, ErrorKind::bad_argument);
}

TEST(ImageReader, TakesTheFirstPartWithColours) {
    expect_pixels("multi_part.exr", source_value);
    EXPECT_TRUE(contains(notes_of("multi_part.exr"), "read number 2 ('beauty')"));
}

TEST(ImageReader, RefusesLuminanceAndChroma) {
    const auto image = read_file(test_data / "reading/luminance_chroma.exr");
    ASSERT_FALSE(image);
    EXPECT_EQ(image.error().kind, ErrorKind::unusable_input);
    EXPECT_TRUE(contains(image.error().message, "chroma"));
}

TEST(ImageReader, IsBlackWhereTheDataWindowHasNoPixel) {
    for (const char* file : {"cropped.exr", "cropped_tiled.exr"}) {
        expect_pixels(file, [](int x, int y, int c) {
            return x >= 5 && x < 25 && y >= 3 && y < 12 ? source_value(x, y, c) : 0.0f;
        });
        EXPECT_TRUE(contains(notes_of(file), "starts at x 5, y 3"));
    }
}

TEST(ImageReader, DropsDataOutsideTheDisplayWindow) {
    for (const char* file : {"overscan.exr", "overscan_tiled.exr"}) {
        expect_pixels(file, source_value);
        EXPECT_TRUE(contains(notes_of(file), "dropped"));
    }
}

TEST(ImageReader, TellsWhatTheFileSays) {
    const auto reader = ImageReader::open(test_data / "reading/acescg.exr");
    ASSERT_TRUE(reader);
    EXPECT_EQ(reader->info().format_name, "openexr");
    EXPECT_TRUE(reader->info().floating_point);
    ASSERT_TRUE(reader->info().chromaticities);
    EXPECT_FLOAT_EQ((*reader->info().chromaticities)[3], 0.830f);
    EXPECT_FALSE(ImageReader::open(test_data / "reading/uint16.tif")->info().floating_point);
    EXPECT_EQ(notes_of("half_zip.exr"), "");
}

TEST(ImageReader, HandsOnTheErrorOfTheSink) {
    auto reader = ImageReader::open(test_data / "reading/float.exr");
    ASSERT_TRUE(reader);
    const Status status = reader->read_rows([](int, int, std::span<const float>) -> Status {
        return Error{ErrorKind::interrupted, "enough"};
    });
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().kind, ErrorKind::interrupted);
}

TEST(ImageReader, RefusesEveryMalformedFile) {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(test_data / "malformed")) {
        const auto image = read_file(entry.path());
        ASSERT_FALSE(image) << entry.path();
        EXPECT_EQ(image.error().kind, ErrorKind::unreadable_input) << image.error().message;
        EXPECT_TRUE(contains(image.error().message, entry.path().string()));
        EXPECT_FALSE(contains(image.error().message, "\n"));
        ++count;
    }
    EXPECT_GE(count, 15);
}

TEST(ImageReader, SaysWhyAPathIsNoFile) {
    const auto reason = [](const fs::path& path) {
        const auto image = read_file(path);
        EXPECT_FALSE(image);
        EXPECT_EQ(image.error().kind, ErrorKind::unreadable_input);
        return image.error().message;
    };
    EXPECT_TRUE(contains(reason("no/such/file.exr"), "no/such/file.exr: no such file"));
    EXPECT_TRUE(contains(reason(test_data), "folder"));
    EXPECT_TRUE(contains(reason("/dev/null"), "not a regular file"));
    EXPECT_TRUE(contains(reason(""), "no such file"));
}

TEST(ImageReader, NamesMissingPermission) {
    if (geteuid() == 0) GTEST_SKIP() << "root may read everything";
    const fs::path path = fs::path(testing::TempDir()) / "forbidden.exr";
    ASSERT_TRUE(write_text_whole(path, "secret"));
    fs::permissions(path, fs::perms::none);
    const auto image = read_file(path);
    fs::permissions(path, fs::perms::owner_all);
    ASSERT_FALSE(image);
    EXPECT_TRUE(contains(image.error().message, "Permission denied"));
}

// A program that takes what is left of a copy that was cut short bakes black floors.
TEST(ImageReader, RefusesEveryPrefixOfAFile) {
    for (const char* name : {"rgbe.hdr", "half_zip.exr", "half_tiled.exr", "half_dwa.exr",
                             "float.pfm", "float.tif", "uint16.tif"}) {
        std::ifstream file(test_data / "reading" / name, std::ios::binary);
        const std::string bytes((std::istreambuf_iterator<char>(file)), {});
        ASSERT_GT(bytes.size(), 100u);
        const fs::path path = fs::path(testing::TempDir()) / ("prefix_" + std::string(name));
        const size_t step = bytes.size() > 1500 ? 37 : 1;
        for (size_t size = bytes.size() - 1; size > 0; size -= std::min(size, step)) {
            ASSERT_TRUE(write_text_whole(path, bytes.substr(0, size)));
            const auto image = read_file(path);
            ASSERT_FALSE(image) << name << " cut to " << size << " of " << bytes.size();
            ASSERT_EQ(image.error().kind, ErrorKind::unreadable_input) << image.error().message;
        }
    }
}

TEST(ReadPng, KnowsWhatWritePngWrote) {
    const fs::path path = fs::path(testing::TempDir()) / "small.png";
    std::vector<uint8_t> bytes;
    for (int i = 0; i < 5 * 3 * 3; ++i) bytes.push_back(static_cast<uint8_t>(5 * i));
    const Status written = write_png(path, 5, 3, bytes);
    ASSERT_TRUE(written) << written.error().message;
    auto reader = ImageReader::open(path);
    ASSERT_TRUE(reader);
    EXPECT_EQ(reader->info().color_space, "sRGB");
    const auto image = read_all(*reader);
    ASSERT_TRUE(image);
    for (size_t i = 0; i < bytes.size(); ++i) EXPECT_NEAR(image->rgb[i] * 255, bytes[i], 1e-3);
}

}  // namespace
}  // namespace splitsum
