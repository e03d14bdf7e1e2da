#include "splitsum/atlas/file_cases.h"

#include <limits>
#include <utility>

#include "splitsum/atlas/image_bytes.h"

namespace splitsum {
namespace {

constexpr int width = 32, height = 16;

// Every pixel differs.
Image image_of(int columns, int rows) {
    Image image(columns, rows);
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            const auto pixel = image.row(y).subspan(3 * static_cast<size_t>(x), 3);
            pixel[0] = 0.5f + static_cast<float>(x) / 64;
            pixel[1] = 0.25f + static_cast<float>(y) / 64;
            pixel[2] = 0.125f + static_cast<float>((x * 5 + y * 3) % 64) / 128;
        }
    return image;
}

Image with(float value, int x, int y, int channel) {
    Image image = image_of(width, height);
    image.row(y)[static_cast<size_t>(3 * x + channel)] = value;
    return image;
}

// The part of `image` that starts at (left, top); black outside of it.
Image part_of(const Image& image, int left, int top, int columns, int rows) {
    Image part(columns, rows);
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            const int from_x = x + left, from_y = y + top;
            if (from_x < 0 || from_y < 0 || from_x >= image.width || from_y >= image.height)
                continue;
            for (size_t c = 0; c < 3; ++c)
                part.row(y)[3 * static_cast<size_t>(x) + c] =
                    image.row(from_y)[3 * static_cast<size_t>(from_x) + c];
        }
    return part;
}

FileCase readable(const char* name, const char* about, std::string bytes, Image truth) {
    return {name, about, std::move(bytes), Reading::light, Reading::light, std::move(truth)};
}

FileCase repairable(const char* name, const char* about, std::string bytes) {
    return {name, about, std::move(bytes), Reading::refusal, Reading::light};
}

FileCase hopeless(const char* name, const char* about, std::string bytes) {
    return {name, about, std::move(bytes), Reading::refusal, Reading::refusal};
}

void add_values(std::vector<FileCase>& cases) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    cases.push_back(repairable("nan.pfm", "a NaN at x 17, y 4", pfm_bytes(with(nan, 17, 4, 1))));
    cases.push_back(repairable("infinite.pfm", "an Inf in the corner x 31, y 0",
                               pfm_bytes(with(infinity, 31, 0, 0))));
    cases.push_back(
        repairable("negative.pfm", "-0.25 at x 0, y 7", pfm_bytes(with(-0.25f, 0, 7, 2))));
    cases.push_back(repairable("half_overflow.exr", "a sun of 1e6 saved in half floats",
                               overflowed_half_exr_bytes(width, height)));
}

void add_shapes(std::vector<FileCase>& cases) {
    struct Shape {
        const char* name;
        const char* about;
        int columns, rows;
    };
    for (const Shape& shape : {Shape{"square.pfm", "16 x 16", 16, 16},
                               {"one_pixel.pfm", "1 x 1", 1, 1},
                               {"one_column.pfm", "1 x 16", 1, 16},
                               {"one_row.pfm", "32 x 1", 32, 1},
                               {"odd.pfm", "33 x 16", 33, 16}})
        cases.push_back(
            hopeless(shape.name, shape.about, pfm_bytes(image_of(shape.columns, shape.rows))));
    cases.push_back(readable("two_pixels.pfm", "2 x 1", pfm_bytes(image_of(2, 1)), image_of(2, 1)));
    cases.push_back(
        readable("odd_rows.pfm", "14 x 7", pfm_bytes(image_of(14, 7)), image_of(14, 7)));
}

void add_windows(std::vector<FileCase>& cases) {
    const Image whole = image_of(width, height);
    const std::vector<ExrPlane> rgb = {{"B", 2}, {"G", 1}, {"R", 0}};
    const ExrWindow display{100, -50, width, height};
    cases.push_back(
        readable("cropped.exr", "data window 20 x 9 inside of 32 x 16, which starts at 100, -50",
                 exr_bytes(part_of(whole, 5, 3, 20, 9), rgb, {105, -47, 20, 9}, display),
                 part_of(part_of(whole, 5, 3, 20, 9), -5, -3, width, height)));
    cases.push_back(readable(
        "overscan.exr", "data window 38 x 22 around 32 x 16",
        exr_bytes(part_of(whole, -3, -3, 38, 22), rgb, {97, -53, 38, 22}, display), whole));
}

void add_channels(std::vector<FileCase>& cases) {
    const Image whole = image_of(width, height);
    const ExrWindow window{0, 0, width, height};
    const auto file = [&](const std::vector<ExrPlane>& planes) {
        return exr_bytes(whole, planes, window, window);
    };
    Image grey = whole;
    for (size_t i = 0; i < grey.rgb.size(); i += 3) grey.rgb[i] = grey.rgb[i + 2] = grey.rgb[i + 1];
    cases.push_back(readable("alpha.exr", "A = 0.5 beside R, G and B",
                             file({{"A", -1, 0.5f}, {"B", 2}, {"G", 1}, {"R", 0}}), whole));
    cases.push_back(readable("grey.exr", "Y alone", file({{"Y", 1}}), grey));
    cases.push_back(readable("extra_channels.exr", "a depth Z of 1e30 beside R, G and B",
                             file({{"B", 2}, {"G", 1}, {"R", 0}, {"Z", -1, 1e30f}}), whole));
    cases.push_back(hopeless("two_layers.exr", "layers fill and key, none of them chosen",
                             file({{"fill.B", 2},
                                   {"fill.G", 1},
                                   {"fill.R", 0},
                                   {"key.B", 0},
                                   {"key.G", 2},
                                   {"key.R", 1}})));
    cases.push_back(hopeless("no_colours.exr", "a depth Z alone", file({{"Z", 0}})));
}

void add_damage(std::vector<FileCase>& cases) {
    const Image whole = image_of(width, height);
    const ExrWindow window{0, 0, width, height};
    const std::string exr = exr_bytes(whole, {{"B", 2}, {"G", 1}, {"R", 0}}, window, window);
    const std::string pfm = pfm_bytes(whole);
    cases.push_back(
        hopeless("cut_short.exr", "two thirds of a file", exr.substr(0, exr.size() * 2 / 3)));
    cases.push_back(
        hopeless("last_byte.exr", "all but the last byte", exr.substr(0, exr.size() - 1)));
    cases.push_back(
        hopeless("cut_short.pfm", "two thirds of a file", pfm.substr(0, pfm.size() * 2 / 3)));
    cases.push_back(hopeless("large_claim.pfm", "65536 x 32768 by its header, and no pixels",
                             "PF\n65536 32768\n-1.0\n"));
    cases.push_back(hopeless("empty.hdr", "no bytes", ""));
    cases.push_back(hopeless("text.exr", "a sentence", "This is a sentence and not an image.\n"));
}

}  // namespace

std::vector<FileCase> file_cases() {
    std::vector<FileCase> cases;
    cases.push_back(readable("plain.pfm", "nothing is wrong with it",
                             pfm_bytes(image_of(width, height)), image_of(width, height)));
    add_values(cases);
    add_shapes(cases);
    add_windows(cases);
    add_channels(cases);
    add_damage(cases);
    return cases;
}

}  // namespace splitsum
