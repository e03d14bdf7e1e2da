#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace splitsum {

/// How one texel is stored. Little-endian, as KTX 2 asks for.
enum class PixelFormat { rgba16f, rgba32f, rgb9e5, b10g11r11, rg16f, rg32f, rg16unorm };

/// What there is to know about a format without decoding it.
struct PixelFormatInfo {
    PixelFormat format;
    std::string_view name;     ///< as typed after --format
    std::string_view summary;  ///< one line for --help
    uint32_t vk_format;        ///< VkFormat of the Vulkan specification
    int bytes_per_texel;
    int channels;                  ///< 2, 3 or 4 that are stored
    std::array<float, 4> largest;  ///< the largest finite value of each channel
    bool holds_negative;           ///< down to -largest
};

/// Every format; one line each.
std::span<const PixelFormatInfo> pixel_formats();

const PixelFormatInfo& info_of(PixelFormat format);

/// The format with that name, or nullptr.
const PixelFormatInfo* find_pixel_format(std::string_view name);

/// How many channel values had to be changed to fit a format, beyond its rounding.
struct EncodeCounts {
    int64_t saturated = 0;  ///< further from 0 than `largest`, stored as `largest` with that sign
    int64_t negative = 0;   ///< below 0 in a format without sign, stored as 0

    EncodeCounts& operator+=(const EncodeCounts& other) {
        saturated += other.saturated;
        negative += other.negative;
        return *this;
    }
    friend EncodeCounts operator+(EncodeCounts a, const EncodeCounts& b) { return a += b; }
};

/// Whether the colours of a cubemap can be stored in it, and the numbers of a table.
bool holds_colours(const PixelFormatInfo& info);
bool holds_tables(const PixelFormatInfo& info);

/// Encodes `values` (`channels` floats a texel, all finite) to `bytes` (bytes_per_texel each). What
/// the format stores beyond `channels` is what a shader reads of a channel that is not there: 0, and
/// 1 for alpha. 1 <= channels <= info_of(format).channels.
///
/// Floats of all widths round to nearest, ties to even; rgb9e5 rounds as its
/// own formula does, ties up. Values that do not fit are changed and counted: never Inf, never
/// silent. The result does not depend on the number of threads.
///
/// rgb9e5: EXT_texture_shared_exponent (Brown, Licea-Kane 2007), "Encoding"; the exponent belongs to
/// the largest channel, so a channel's rounding error is at most 1/1024 of the power of two above
/// the largest one.
/// rg16unorm: whole 65535ths of 1, rounded to nearest.
/// b10g11r11: floats without sign of 6, 6 and 5 mantissa bits, exponent bias 15, with denormals.
EncodeCounts encode_texels(PixelFormat format, int channels, std::span<const float> values,
                           std::span<std::byte> bytes);

/// The inverse of encode_texels, of the first `channels` channels. Exact, because every stored value
/// is a float, but for rg16unorm, which is rounded to the nearest float.
void decode_texels(PixelFormat format, int channels, std::span<const std::byte> bytes,
                   std::span<float> values);

}  // namespace splitsum
