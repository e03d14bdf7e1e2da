#include "write_simple.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <span>
#include <stdexcept>
#include <vector>

#include "splitsum/base/text.h"

namespace splitsum::test_data {
namespace {

void append(std::string& bytes, uint32_t value, int size) {
    for (int i = 0; i < size; ++i) bytes += static_cast<char>(value >> (8 * i) & 255);
}

void append(std::string& bytes, float value) { append(bytes, std::bit_cast<uint32_t>(value), 4); }

/// One exponent for three mantissas; the largest mantissa is in [128, 256).
std::array<uint8_t, 4> rgbe_of(std::span<const float> rgb) {
    const float largest = std::max({rgb[0], rgb[1], rgb[2]});
    if (largest < 1e-32f) return {0, 0, 0, 0};
    int exponent = 0;
    const double factor = std::frexp(largest, &exponent) * 256 / largest;
    return {static_cast<uint8_t>(rgb[0] * factor), static_cast<uint8_t>(rgb[1] * factor),
            static_cast<uint8_t>(rgb[2] * factor), static_cast<uint8_t>(exponent + 128)};
}

/// Runs of 2 to 127 equal bytes as (128 + count, value), others as (count, values).
void append_packed(std::string& bytes, const std::vector<uint8_t>& values) {
    const auto run_at = [&](size_t i) {
        size_t n = 1;
        while (i + n < values.size() && n < 127 && values[i + n] == values[i]) ++n;
        return n;
    };
    for (size_t i = 0; i < values.size();) {
        if (const size_t run = run_at(i); run > 2) {
            append(bytes, 128 + static_cast<uint32_t>(run), 1);
            append(bytes, values[i], 1);
            i += run;
            continue;
        }
        size_t end = i;
        while (end < values.size() && end - i < 128 && run_at(end) <= 2) ++end;
        append(bytes, static_cast<uint32_t>(end - i), 1);
        for (; i < end; ++i) append(bytes, values[i], 1);
    }
}

void append_hdr_row(std::string& bytes, std::span<const float> row) {
    const size_t width = row.size() / 3;
    bytes += "\x02\x02";
    append(bytes, static_cast<uint32_t>(width) >> 8, 1);
    append(bytes, static_cast<uint32_t>(width) & 255, 1);
    std::array<std::vector<uint8_t>, 4> planes;
    for (size_t x = 0; x < width; ++x) {
        const auto rgbe = rgbe_of(row.subspan(3 * x, 3));
        for (size_t c = 0; c < 4; ++c) planes[c].push_back(rgbe[c]);
    }
    for (const auto& plane : planes) append_packed(bytes, plane);
}

void append_tag(std::string& bytes, uint32_t tag, uint32_t type, uint32_t count, uint32_t value) {
    append(bytes, tag, 2);
    append(bytes, type, 2);
    append(bytes, count, 4);
    append(bytes, value, 4);
}

}  // namespace

std::string hdr_bytes(const Image& image) {
    std::string bytes =
        cat("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y ", image.height, " +X ", image.width, "\n");
    for (int y = 0; y < image.height; ++y) append_hdr_row(bytes, image.row(y));
    return bytes;
}

std::string pfm_bytes(const Image& image) {
    std::string bytes = cat("PF\n", image.width, " ", image.height, "\n-1.0\n");
    for (int y = image.height - 1; y >= 0; --y)
        for (const float value : image.row(y)) append(bytes, value);
    return bytes;
}

std::string tiff_bytes(const Image& image, TiffSample sample) {
    constexpr uint32_t short_type = 3, long_type = 4, entries = 11, header_size = 8;
    constexpr uint32_t directory_size = 2 + 12 * entries + 4;
    constexpr uint32_t bits_at = header_size + directory_size, formats_at = bits_at + 6;
    constexpr uint32_t pixels_at = formats_at + 6;
    const bool floating = sample == TiffSample::float32;
    const uint32_t sample_size = floating ? 4 : 2;

    std::string bytes("II*\0", 4);
    append(bytes, header_size, 4);
    append(bytes, entries, 2);
    append_tag(bytes, 256, long_type, 1, static_cast<uint32_t>(image.width));
    append_tag(bytes, 257, long_type, 1, static_cast<uint32_t>(image.height));
    append_tag(bytes, 258, short_type, 3, bits_at);
    append_tag(bytes, 259, short_type, 1, 1);  // no compression
    append_tag(bytes, 262, short_type, 1, 2);  // RGB
    append_tag(bytes, 273, long_type, 1, pixels_at);
    append_tag(bytes, 277, short_type, 1, 3);
    append_tag(bytes, 278, long_type, 1, static_cast<uint32_t>(image.height));
    append_tag(bytes, 279, long_type, 1, sample_size * static_cast<uint32_t>(image.rgb.size()));
    append_tag(bytes, 284, short_type, 1, 1);  // interleaved
    append_tag(bytes, 339, short_type, 3, formats_at);
    append(bytes, 0, 4);  // no further directory
    for (int c = 0; c < 3; ++c) append(bytes, 8 * sample_size, 2);
    for (int c = 0; c < 3; ++c) append(bytes, floating ? 3 : 1, 2);
    for (const float value : image.rgb) {
        if (floating)
            append(bytes, value);
        else
            append(bytes, static_cast<uint32_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 65535)),
                   2);
    }
    return bytes;
}

void write_bytes(const std::filesystem::path& path, const std::string& bytes) {
    std::ofstream file(path, std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) throw std::runtime_error(cat("cannot write ", path.string()));
}

}  // namespace splitsum::test_data
