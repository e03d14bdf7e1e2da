#include "splitsum/preview/page_texels.h"

#include <algorithm>
#include <cstddef>

#include "splitsum/base/base64.h"
#include "splitsum/texture/pixel_format.h"

namespace splitsum {
namespace {

// A format of a page, by the stored format that has the same numbers.
struct PageFormat {
    std::string_view name;
    PixelFormat stored;
    int channels;
    int bytes_per_texel;  // without channels that a page leaves out
};

// From small to large; the last one takes everything.
constexpr PageFormat colour_formats[] = {
    {"rgb9e5", PixelFormat::rgb9e5, 3, 4},
    {"b10g11r11", PixelFormat::b10g11r11, 3, 4},
    {"rgb16f", PixelFormat::rgba16f, 3, 6},
};
constexpr PageFormat table_format = {"rg16f", PixelFormat::rg16f, 2, 4};

struct Encoded {
    std::vector<std::byte> bytes;  // as stored
    bool exact;
};

Encoded encode(const PageFormat& format, std::span<const float> values) {
    const size_t texels = values.size() / size_t(format.channels);
    Encoded encoded{std::vector<std::byte>(texels * size_t(info_of(format.stored).bytes_per_texel)),
                    true};
    encode_texels(format.stored, format.channels, values, encoded.bytes);
    std::vector<float> decoded(values.size());
    decode_texels(format.stored, format.channels, encoded.bytes, decoded);
    encoded.exact = std::ranges::equal(values, decoded);
    return encoded;
}

std::string text_of(const PageFormat& format, std::span<const std::byte> stored) {
    const auto stride = size_t(info_of(format.stored).bytes_per_texel);
    const auto kept = size_t(format.bytes_per_texel);
    std::string bytes;
    bytes.reserve(stored.size() / stride * kept);
    for (size_t at = 0; at < stored.size(); at += stride)
        bytes.append(reinterpret_cast<const char*>(stored.data()) + at, kept);
    return base64(bytes);
}

PageTexels texels_in(const PageFormat& format, std::span<const float> values) {
    const Encoded encoded = encode(format, values);
    return {format.name, text_of(format, encoded.bytes), encoded.exact};
}

std::vector<float> values_of(std::span<const Cubemap> levels) {
    std::vector<float> values;
    for (const Cubemap& level : levels)
        for (const Vec3& texel : level.texels)
            values.insert(values.end(), {texel.x, texel.y, texel.z});
    return values;
}

}  // namespace

PageTexels page_texels(std::span<const Cubemap> levels) {
    const std::vector<float> values = values_of(levels);
    for (const PageFormat& format : colour_formats) {
        const Encoded encoded = encode(format, values);
        if (encoded.exact) return {format.name, text_of(format, encoded.bytes), true};
    }
    return texels_in(std::end(colour_formats)[-1], values);
}

PageTexels page_texels(const Table& table) {
    std::vector<float> values;
    for (int y = 0; y < table.height; ++y)
        for (int x = 0; x < table.width; ++x) {
            const auto texel = table.texel(x, y);
            values.insert(values.end(), {texel[0], texel[1]});
        }
    return texels_in(table_format, values);
}

PageTexels page_texels(const Image& picture) {
    return texels_in(std::end(colour_formats)[-1], picture.rgb);
}

}  // namespace splitsum
