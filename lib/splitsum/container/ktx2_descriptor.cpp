#include <bit>
#include <span>

#include "splitsum/container/ktx2_descriptor_detail.h"

namespace splitsum::ktx2 {
namespace {

// One run of bits of a texel: which channel it belongs to and how to read it.
struct Sample {
    uint32_t bit_offset;
    uint32_t bit_length;
    uint32_t channel;  // with the qualifiers
    uint32_t lower;    // the stored value that stands for 0, or -1 if signed
    uint32_t upper;    // the stored value that stands for 1
};

constexpr uint32_t red = 0, green = 1, blue = 2, alpha_channel = 15;
constexpr uint32_t exponent_qualifier = 0x20, signed_qualifier = 0x40, float_qualifier = 0x80;

constexpr Sample signed_float(uint32_t channel, uint32_t bit_offset, uint32_t bit_length) {
    return {bit_offset, bit_length, channel | float_qualifier | signed_qualifier,
            std::bit_cast<uint32_t>(-1.0f), std::bit_cast<uint32_t>(1.0f)};
}

constexpr Sample unsigned_float(uint32_t channel, uint32_t bit_offset, uint32_t bit_length) {
    return {bit_offset, bit_length, channel | float_qualifier, 0, std::bit_cast<uint32_t>(1.0f)};
}

constexpr Sample unsigned_normalised(uint32_t channel, uint32_t bit_offset, uint32_t bit_length) {
    return {bit_offset, bit_length, channel, 0, (1u << bit_length) - 1};
}

// A shared-exponent channel is a pair: its mantissa, and the exponent with its bias and its maximum.
// 1.0 is mantissa 256 with exponent 16, which the Khronos Data Format Specification writes as one
// number with the exponent on top: 16 * 512 + 256.
constexpr Sample mantissa(uint32_t channel, uint32_t bit_offset) {
    return {bit_offset, 9, channel, 0, 16 * 512 + 256};
}
constexpr Sample shared_exponent(uint32_t channel) {
    return {27, 5, channel | exponent_qualifier, 15, 31};
}

constexpr Sample rgba16f[] = {signed_float(red, 0, 16), signed_float(green, 16, 16),
                              signed_float(blue, 32, 16), signed_float(alpha_channel, 48, 16)};
constexpr Sample rgba32f[] = {signed_float(red, 0, 32), signed_float(green, 32, 32),
                              signed_float(blue, 64, 32), signed_float(alpha_channel, 96, 32)};
constexpr Sample rgb9e5[] = {mantissa(red, 0),       shared_exponent(red), mantissa(green, 9),
                             shared_exponent(green), mantissa(blue, 18),   shared_exponent(blue)};
constexpr Sample b10g11r11[] = {unsigned_float(red, 0, 11), unsigned_float(green, 11, 11),
                                unsigned_float(blue, 22, 10)};
constexpr Sample rg16f[] = {signed_float(red, 0, 16), signed_float(green, 16, 16)};
constexpr Sample rg32f[] = {signed_float(red, 0, 32), signed_float(green, 32, 32)};
constexpr Sample rg16unorm[] = {unsigned_normalised(red, 0, 16),
                                unsigned_normalised(green, 16, 16)};

struct Layout {
    PixelFormat format;
    uint32_t type_size;
    std::span<const Sample> samples;
};

constexpr Layout layouts[] = {
    {PixelFormat::rgba16f, 2, rgba16f},     {PixelFormat::rgba32f, 4, rgba32f},
    {PixelFormat::rgb9e5, 4, rgb9e5},       {PixelFormat::b10g11r11, 4, b10g11r11},
    {PixelFormat::rg16f, 2, rg16f},         {PixelFormat::rg32f, 4, rg32f},
    {PixelFormat::rg16unorm, 2, rg16unorm},
};

const Layout& layout_of(PixelFormat format) { return layouts[static_cast<size_t>(format)]; }

constexpr bool in_enum_order() {
    for (size_t i = 0; i < std::size(layouts); ++i)
        if (static_cast<size_t>(layouts[i].format) != i) return false;
    return true;
}
static_assert(in_enum_order());

}  // namespace

std::vector<uint32_t> descriptor_of(PixelFormat format, bool supercompressed) {
    constexpr uint32_t version_1_3 = 2, model_rgbsda = 1, primaries_bt709 = 1, transfer_linear = 1;
    const std::span<const Sample> samples = layout_of(format).samples;
    const auto block_size = static_cast<uint32_t>(24 + 16 * samples.size());
    const auto bytes = static_cast<uint32_t>(info_of(format).bytes_per_texel);
    std::vector<uint32_t> words = {
        4 + block_size,
        0,  // vendor Khronos, a basic block
        version_1_3 | block_size << 16,
        model_rgbsda | primaries_bt709 << 8 | transfer_linear << 16,  // flags 0: straight alpha
        0,                                                            // a texel block is one texel
        supercompressed ? 0 : bytes,
        0,
    };
    for (const Sample& sample : samples)
        words.insert(words.end(),
                     {sample.bit_offset | (sample.bit_length - 1) << 16 | sample.channel << 24, 0,
                      sample.lower, sample.upper});
    return words;
}

uint32_t type_size_of(PixelFormat format) { return layout_of(format).type_size; }

}  // namespace splitsum::ktx2
