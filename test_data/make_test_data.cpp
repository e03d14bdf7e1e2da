// Writes every image of this folder anew: make_test_data FOLDER. What each one is for is told in
// README.md.

#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>

#include "skies.h"
#include "splitsum/base/text.h"
#include "write_exr.h"
#include "write_simple.h"

namespace splitsum::test_data {
namespace {

namespace fs = std::filesystem;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

std::string bytes_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error(cat("cannot read ", path.string()));
    return {std::istreambuf_iterator<char>(file), {}};
}

void write_panoramas(const fs::path& folder) {
    write_exr(folder / "lopsided.exr", panorama_of(lopsided_sky, 64, 1));
    write_exr(folder / "one_texel.exr", one_texel_panorama(64));
    ExrPlan in_float;
    in_float.half = false;
    write_exr(folder / "sun.exr", sun_panorama(64), in_float);
    write_exr(folder / "studio.exr", panorama_of(studio_sky, 128, 8));
    write_bytes(folder / "night.hdr", hdr_bytes(panorama_of(night_sky, 128, 4)));
    ExrPlan piz;
    piz.compression = ExrCompression::piz;
    write_exr(folder / "sunset.exr", panorama_of(sunset_sky, 256, 4), piz);
}

/// The small image of reading/: every pixel differs, all values are exact in half floats and RGBE.
Image reading_image() {
    Image image(32, 16);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const auto pixel = image.row(y).subspan(3 * static_cast<size_t>(x), 3);
            pixel[0] = 0.5f + static_cast<float>(x) / 64;
            pixel[1] = 0.25f + static_cast<float>(y) / 64;
            pixel[2] = 0.125f + static_cast<float>((x * 5 + y * 3) % 64) / 128;
        }
    return image;
}

Image part_of(const Image& image, int x0, int y0, int width, int height) {
    Image part(width, height);
    for (int y = 0; y < height; ++y)
        for (int i = 0; i < 3 * width; ++i)
            part.row(y)[static_cast<size_t>(i)] =
                image.row(y + y0)[static_cast<size_t>(i + 3 * x0)];
    return part;
}

Image framed(const Image& image, int frame) {
    Image wider(image.width + 2 * frame, image.height + 2 * frame);
    for (float& value : wider.rgb) value = 9;
    for (int y = 0; y < image.height; ++y)
        for (int i = 0; i < 3 * image.width; ++i)
            wider.row(y + frame)[static_cast<size_t>(i + 3 * frame)] =
                image.row(y)[static_cast<size_t>(i)];
    return wider;
}

void write_exr_storage(const fs::path& folder, const Image& image) {
    ExrPlan plan;
    write_exr(folder / "half_zip.exr", image, plan);
    plan.tile_size = 12;
    write_exr(folder / "half_tiled.exr", image, plan);
    plan.tile_size = 0;
    plan.half = false;
    write_exr(folder / "float.exr", image, plan);
    plan.half = true;
    plan.compression = ExrCompression::dwaa;
    write_exr(folder / "half_dwa.exr", image, plan);
}

void write_exr_channels(const fs::path& folder, const Image& image) {
    ExrPlan plan;
    plan.channels = {{"Y", 1, 0}};
    write_exr(folder / "grey.exr", image, plan);
    plan.channels = {{"Y", 1, 0}, {"A", -1, 0.5f}};
    write_exr(folder / "grey_alpha.exr", image, plan);
    plan.channels = {{"R", 0, 0}, {"G", 1, 0}, {"B", 2, 0}, {"A", -1, 0.5f}};
    write_exr(folder / "rgba.exr", image, plan);
    plan.channels = {{"R", 0, 0}, {"G", 1, 0}, {"B", 2, 0}, {"Z", -1, 7}, {"id.x", -1, 3}};
    write_exr(folder / "extra_channels.exr", image, plan);
    plan.channels = {
        {"beauty.R", 0, 0}, {"beauty.G", 1, 0}, {"beauty.B", 2, 0}, {"depth.Z", -1, 7}};
    write_exr(folder / "one_layer.exr", image, plan);
    plan.channels = {{"key.R", 0, 0},  {"key.G", 1, 0},  {"key.B", 2, 0},
                     {"fill.R", 2, 0}, {"fill.G", 0, 0}, {"fill.B", 1, 0}};
    write_exr(folder / "two_layers.exr", image, plan);
    plan.channels = {{"R", 0, 0},      {"G", 1, 0},      {"B", 2, 0},
                     {"fill.R", 2, 0}, {"fill.G", 0, 0}, {"fill.B", 1, 0}};
    write_exr(folder / "default_and_layer.exr", image, plan);
    write_luminance_chroma_exr(folder / "luminance_chroma.exr", image);
    write_multi_part_exr(folder / "multi_part.exr", image);
}

void write_exr_windows(const fs::path& folder, const Image& image) {
    ExrPlan plan;
    plan.display = {100, -50, image.width, image.height};
    plan.data = {105, -47, 20, 9};
    const Image cropped = part_of(image, 5, 3, 20, 9);
    write_exr(folder / "cropped.exr", cropped, plan);
    plan.tile_size = 8;
    write_exr(folder / "cropped_tiled.exr", cropped, plan);
    plan.data = {100 - 3, -50 - 3, image.width + 6, image.height + 6};
    write_exr(folder / "overscan_tiled.exr", framed(image, 3), plan);
    plan.tile_size = 0;
    write_exr(folder / "overscan.exr", framed(image, 3), plan);
}

void write_reading(const fs::path& folder) {
    const Image image = reading_image();
    write_exr_storage(folder, image);
    write_exr_channels(folder, image);
    write_exr_windows(folder, image);
    ExrPlan plan;
    plan.chromaticities = {0.713f, 0.293f, 0.165f, 0.830f, 0.128f, 0.044f, 0.32168f, 0.33767f};
    write_exr(folder / "acescg.exr", image, plan);
    write_bytes(folder / "rgbe.hdr", hdr_bytes(image));
    std::string flipped = hdr_bytes(image);
    flipped.replace(flipped.find("-Y"), 2, "+Y");
    write_bytes(folder / "upside_down.hdr", flipped);
    write_bytes(folder / "float.pfm", pfm_bytes(image));
    write_bytes(folder / "float.tif", tiff_bytes(image, TiffSample::float32));
    write_bytes(folder / "uint16.tif", tiff_bytes(image, TiffSample::uint16));
    write_exr(folder / "2x1.exr", part_of(image, 0, 0, 2, 1));
}

void write_unusable(const fs::path& folder) {
    const auto with = [](int x, int y, int channel, float value) {
        Image image = reading_image();
        image.row(y)[static_cast<size_t>(3 * x + channel)] = value;
        return image;
    };
    write_exr(folder / "square.exr", part_of(reading_image(), 0, 0, 16, 16));
    write_exr(folder / "1x1.exr", part_of(reading_image(), 0, 0, 1, 1));
    write_exr(folder / "nan.exr", with(17, 4, 1, nan));
    write_exr(folder / "inf.exr", with(31, 0, 0, infinity));
    write_exr(folder / "half_overflow.exr", with(9, 15, 2, 1e6f));
    write_exr(folder / "negative.exr", with(0, 7, 2, -0.25f));
    ExrPlan plan;
    plan.channels = {{"Z", -1, 7}, {"N.x", 0, 0}, {"N.y", 1, 0}};
    write_exr(folder / "no_colors.exr", reading_image(), plan);
    // A green outside the gamut of Rec.709, in a file that says it is ACEScg.
    plan = {};
    plan.chromaticities = {0.713f, 0.293f, 0.165f, 0.830f, 0.128f, 0.044f, 0.32168f, 0.33767f};
    write_exr(folder / "out_of_gamut.exr", with(3, 2, 1, 40), plan);
}

/// Sets the corners of both windows in the bytes of an EXR file: x, y of the last pixels.
std::string with_windows(std::string bytes, int32_t last_x, int32_t last_y) {
    for (const std::string name : {"dataWindow", "displayWindow"}) {
        // "<name>\0box2i\0", four bytes of length, then the first and the last pixel.
        const size_t corners = bytes.find(name) + name.size() + 1 + 6 + 4;
        std::memcpy(bytes.data() + corners + 8, &last_x, 4);
        std::memcpy(bytes.data() + corners + 12, &last_y, 4);
    }
    return bytes;
}

void write_malformed(const fs::path& folder, const fs::path& reading) {
    const std::string exr = bytes_of(reading / "half_zip.exr");
    const std::string hdr = bytes_of(reading / "rgbe.hdr");
    const std::string tif = bytes_of(reading / "float.tif");
    const std::string head = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n";
    write_bytes(folder / "empty.hdr", "");
    write_bytes(folder / "truncated.hdr", hdr.substr(0, hdr.size() * 2 / 3));
    write_bytes(folder / "truncated.exr", exr.substr(0, exr.size() * 2 / 3));
    write_bytes(folder / "truncated.tif", tif.substr(0, tif.size() * 2 / 3));
    write_bytes(folder / "last_byte_missing.hdr", hdr.substr(0, hdr.size() - 1));
    write_bytes(folder / "last_byte_missing.exr", exr.substr(0, exr.size() - 1));
    write_bytes(folder / "last_byte_missing.tif", tif.substr(0, tif.size() - 1));
    write_bytes(folder / "wrong_magic.exr", "gniK" + exr.substr(4));
    write_bytes(folder / "zero_by_zero.hdr", head + "-Y 0 +X 0\n");
    write_bytes(folder / "absurd_header.hdr", head + "-Y 1000000000 +X 2000000000\n");
    write_bytes(folder / "large_claim.hdr", head + "-Y 32768 +X 65536\n");
    write_bytes(folder / "absurd_header.exr", with_windows(exr, 1999999999, 999999999));
    write_bytes(folder / "large_claim.exr", with_windows(exr, 65535, 32767));
    write_bytes(folder / "zero_by_zero.exr", with_windows(exr, -1, -1));
    write_bytes(folder / "text.exr", "This is a sentence, not an image.\n");
}

void write_everything(const fs::path& folder) {
    for (const char* name : {"panoramas", "reading", "unusable", "malformed"})
        fs::create_directories(folder / name);
    write_panoramas(folder / "panoramas");
    write_reading(folder / "reading");
    write_unusable(folder / "unusable");
    write_malformed(folder / "malformed", folder / "reading");
}

}  // namespace
}  // namespace splitsum::test_data

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: make_test_data FOLDER\n";
        return 2;
    }
    try {
        splitsum::test_data::write_everything(argv[1]);
        return 0;
    } catch (const std::exception& failure) {
        std::cerr << "make_test_data: " << failure.what() << "\n";
        return 4;
    }
}
