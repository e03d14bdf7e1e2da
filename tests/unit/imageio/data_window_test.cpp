#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <vector>

#include "splitsum/base/text.h"
#include "splitsum/imageio/image_file.h"
#include "support/temporary_folder.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

constexpr int width = 40;  // of the display window
constexpr int height = 100;

struct Window {
    int left, top, right, bottom;

    bool holds(int x, int y) const { return left <= x && x < right && top <= y && y < bottom; }
};

// Numbers that halves hold exactly.
float value_at(int x, int y, int channel) {
    return channel == 0 ? float(x + 20) : channel == 1 ? float(y + 20) : 200.0f;
}

bool write(const fs::path& path, const Window& data, OIIO::TypeDesc type, int channels) {
    OIIO::ImageSpec spec(data.right - data.left, data.bottom - data.top, channels, type);
    spec.x = data.left;
    spec.y = data.top;
    spec.full_width = width;
    spec.full_height = height;
    std::vector<float> values;
    for (int y = data.top; y < data.bottom; ++y)
        for (int x = data.left; x < data.right; ++x)
            for (int c = 0; c < channels; ++c) values.push_back(value_at(x, y, c));
    const auto file = OIIO::ImageOutput::create(path.string());
    return file && file->open(path.string(), spec) &&
           file->write_image(OIIO::TypeFloat, values.data()) && file->close();
}

int wrong_values(const fs::path& path, const Window& data) {
    auto reader = ImageReader::open(path);
    if (!reader) return -1;
    int wrong = 0;
    const auto compare = [&](int first_row, int row_count, std::span<float> rgb) -> Status {
        size_t i = 0;
        for (int y = first_row; y < first_row + row_count; ++y)
            for (int x = 0; x < width; ++x)
                for (int c = 0; c < 3; ++c)
                    wrong += rgb[i++] != (data.holds(x, y) ? value_at(x, y, c) : 0);
        return ok;
    };
    return reader->read_rows(compare) ? wrong : -1;
}

// Rows that fill the display window's width are read without a copy; no others may be.
TEST(DataWindow, MayLieAnywhereAcrossTheDisplayWindow) {
    const tests::TemporaryFolder folder;
    const fs::path path = folder.path() / "window.exr";
    for (const int left : {-3, 0, 7})
        for (const int right : {31, width - 3, width, width + 7})
            for (const int top : {-9, 0, 11})
                for (const int bottom : {70, height, height + 13})
                    for (const auto& type : {OIIO::TypeHalf, OIIO::TypeFloat})
                        for (const int channels : {3, 4}) {
                            const Window data{left, top, right, bottom};
                            ASSERT_TRUE(write(path, data, type, channels));
                            ASSERT_EQ(wrong_values(path, data), 0)
                                << cat(left, ", ", top, " to ", right, ", ", bottom, ", ",
                                       type.c_str(), ", ", channels, " channels");
                        }
}

}  // namespace
}  // namespace splitsum
