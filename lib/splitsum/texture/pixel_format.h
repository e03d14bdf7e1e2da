#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace splitsum {

/// How one texel is stored. Little-endian, as KTX 2 asks for.
enum class PixelFormat { rgba16f, rgba32f, rgb9e5, b10g11r11, rg16f, rg32f };

/// What there is to know about a format without decoding it.
struct PixelFormatInfo {
    PixelFormat format;
    std::string_view name;   ///< as typed after --format
    std::string_view summary;
    uint32_t vk_format;      ///< VkFormat of the Vulkan specification
    int bytes_per_texel;
    int channels;            ///< 2 or 3; rgba formats hold RGB and alpha 1
    double largest;          ///< the largest finite value, where saturation begins
    bool holds_negative;
};

/// Every format; one line each.
std::span<const PixelFormatInfo> pixel_formats();

const PixelFormatInfo& info_of(PixelFormat format);

/// The format with that name, or nullptr.
const PixelFormatInfo* find_pixel_format(std::string_view name);

/// How many channel values had to be changed to fit a format, beyond its rounding.
struct EncodeCounts {
    int64_t saturated = 0;  ///< above `largest`, stored as `largest`
    int64_t negative = 0;   ///< below 0 in a format without sign, stored as 0

    EncodeCounts& operator+=(const EncodeCounts& other) {
        saturated += other.saturated;
        negative += other.negative;
        return *this;
    }
};

/// Encodes `values` (info_of(format).channels floats a texel, all finite) to `bytes`
/// (bytes_per_texel each), rounded to nearest. Values that do not fit are changed and counted:
/// never Inf, never NaN, never silent.
EncodeCounts encode_texels(PixelFormat format, std::span<const float> values,
                           std::span<std::byte> bytes);

/// The inverse of encode_texels, exact: every stored value is a float.
void decode_texels(PixelFormat format, std::span<const std::byte> bytes, std::span<float> values);

}  // namespace splitsum
