#include "splitsum/texture/pixel_format.h"

#include <Imath/half.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstring>
#include <limits>

#include "splitsum/base/parallel.h"
#include "splitsum/texture/small_float_detail.h"

namespace splitsum {
namespace {

static_assert(std::endian::native == std::endian::little,
              "texels are copied as they lie in memory");

constexpr std::array<float, 4> every_channel(float largest) {
    return {largest, largest, largest, largest};
}

constexpr float largest_half = 65504;
constexpr float largest_float = std::numeric_limits<float>::max();

constexpr PixelFormatInfo formats[] = {
    {PixelFormat::rgba16f, "rgba16f", "half floats, 8 bytes a texel: what every engine reads", 97,
     8, 4, every_channel(largest_half), true},
    {PixelFormat::rgba32f, "rgba32f", "floats, 16 bytes a texel: nothing is lost", 109, 16, 4,
     every_channel(largest_float), true},
    {PixelFormat::rgb9e5, "rgb9e5", "three 9-bit mantissas with one exponent, 4 bytes a texel", 123,
     4, 3, every_channel(65408), false},
    {PixelFormat::b10g11r11,
     "b10g11r11",
     "floats of 11, 11 and 10 bits, 4 bytes a texel",
     122,
     4,
     3,
     {65024, 65024, 64512, 0},
     false},
    {PixelFormat::rg16f, "rg16f", "two half floats, 4 bytes a texel: tables", 83, 4, 2,
     every_channel(largest_half), true},
    {PixelFormat::rg32f, "rg32f", "two floats, 8 bytes a texel: tables without loss", 103, 8, 2,
     every_channel(largest_float), true},
    {PixelFormat::rg16unorm, "rg16unorm",
     "two 65535ths of 1, 4 bytes a texel: tables between 0 and 1", 77, 4, 2, every_channel(1),
     false},
};

float clamped(const PixelFormatInfo& info, int channel, float value, EncodeCounts& counts) {
    const float largest = info.largest[static_cast<size_t>(channel)];
    if (value < 0 && !info.holds_negative) {
        ++counts.negative;
        return 0;
    }
    if (std::abs(value) <= largest) return value;
    ++counts.saturated;
    return value < 0 ? -largest : largest;
}

// One texel of each format: from and to all of its channels, as floats that fit.
using TexelEncoder = void (*)(const float* values, std::byte* texel);
using TexelDecoder = void (*)(const std::byte* texel, float* values);

template <class Stored>
void store(std::byte* texel, const Stored& stored) {
    std::memcpy(texel, &stored, sizeof stored);
}

template <class Stored>
Stored load(const std::byte* texel) {
    Stored stored;
    std::memcpy(&stored, texel, sizeof stored);
    return stored;
}

void encode_rgba16f(const float* v, std::byte* texel) {
    store(texel, std::array<uint16_t, 4>{imath_float_to_half(v[0]), imath_float_to_half(v[1]),
                                         imath_float_to_half(v[2]), imath_float_to_half(v[3])});
}

void encode_rgba32f(const float* v, std::byte* texel) { std::memcpy(texel, v, 16); }

void encode_rgb9e5(const float* v, std::byte* texel) {
    store(texel, bits_of_rgb9e5({v[0], v[1], v[2]}));
}

void encode_b10g11r11(const float* v, std::byte* texel) {
    store(texel, bits_of_unsigned_float<6>(v[0]) | bits_of_unsigned_float<6>(v[1]) << 11 |
                     bits_of_unsigned_float<5>(v[2]) << 22);
}

void encode_rg16f(const float* v, std::byte* texel) {
    store(texel, std::array<uint16_t, 2>{imath_float_to_half(v[0]), imath_float_to_half(v[1])});
}

void encode_rg32f(const float* v, std::byte* texel) { std::memcpy(texel, v, 8); }

// In fp64, where 65535 v + 1/2 is exact enough that no tie goes astray.
uint16_t unorm_of(float v) { return static_cast<uint16_t>(65535.0 * static_cast<double>(v) + 0.5); }

void encode_rg16unorm(const float* v, std::byte* texel) {
    store(texel, std::array<uint16_t, 2>{unorm_of(v[0]), unorm_of(v[1])});
}

void decode_rg16unorm(const std::byte* texel, float* v) {
    const auto stored = load<std::array<uint16_t, 2>>(texel);
    for (size_t c = 0; c < 2; ++c) v[c] = static_cast<float>(stored[c] / 65535.0);
}

template <int channels>
void decode_halfs(const std::byte* texel, float* v) {
    const auto halfs = load<std::array<uint16_t, channels>>(texel);
    for (size_t c = 0; c < channels; ++c) v[c] = imath_half_to_float(halfs[c]);
}

template <int channels>
void decode_floats(const std::byte* texel, float* v) {
    std::memcpy(v, texel, channels * sizeof(float));
}

void decode_rgb9e5(const std::byte* texel, float* v) {
    std::ranges::copy(rgb_of_rgb9e5(load<uint32_t>(texel)), v);
}

// These floats are halfs without the sign and the last mantissa bits.
void decode_b10g11r11(const std::byte* texel, float* v) {
    const auto bits = load<uint32_t>(texel);
    v[0] = imath_half_to_float(static_cast<uint16_t>((bits & 0x7ff) << 4));
    v[1] = imath_half_to_float(static_cast<uint16_t>(((bits >> 11) & 0x7ff) << 4));
    v[2] = imath_half_to_float(static_cast<uint16_t>((bits >> 22) << 5));
}

constexpr std::array<float, 4> absent_channels = {0, 0, 0, 1};

template <TexelEncoder encode_texel>
EncodeCounts encode_run(const PixelFormatInfo& info, int channels, const float* values,
                        std::byte* bytes, size_t texels) {
    EncodeCounts counts;
    for (size_t i = 0; i < texels; ++i, values += channels, bytes += info.bytes_per_texel) {
        std::array<float, 4> fitting = absent_channels;
        for (int c = 0; c < channels; ++c)
            fitting[static_cast<size_t>(c)] = clamped(info, c, values[c], counts);
        encode_texel(fitting.data(), bytes);
    }
    return counts;
}

template <TexelDecoder decode_texel>
void decode_run(const PixelFormatInfo& info, int channels, const std::byte* bytes, float* values,
                size_t texels) {
    for (size_t i = 0; i < texels; ++i, values += channels, bytes += info.bytes_per_texel) {
        std::array<float, 4> stored;
        decode_texel(bytes, stored.data());
        std::copy_n(stored.data(), channels, values);
    }
}

struct Codec {
    PixelFormat format;
    EncodeCounts (*encode)(const PixelFormatInfo&, int, const float*, std::byte*, size_t);
    void (*decode)(const PixelFormatInfo&, int, const std::byte*, float*, size_t);
};

constexpr Codec codecs[] = {
    {PixelFormat::rgba16f, encode_run<encode_rgba16f>, decode_run<decode_halfs<4>>},
    {PixelFormat::rgba32f, encode_run<encode_rgba32f>, decode_run<decode_floats<4>>},
    {PixelFormat::rgb9e5, encode_run<encode_rgb9e5>, decode_run<decode_rgb9e5>},
    {PixelFormat::b10g11r11, encode_run<encode_b10g11r11>, decode_run<decode_b10g11r11>},
    {PixelFormat::rg16f, encode_run<encode_rg16f>, decode_run<decode_halfs<2>>},
    {PixelFormat::rg32f, encode_run<encode_rg32f>, decode_run<decode_floats<2>>},
    {PixelFormat::rg16unorm, encode_run<encode_rg16unorm>, decode_run<decode_rg16unorm>},
};

// Both tables are in the order of the enumeration, so that a format is its own index.
template <class Table>
constexpr bool in_enum_order(const Table& table) {
    for (size_t i = 0; i < std::size(table); ++i)
        if (static_cast<size_t>(table[i].format) != i) return false;
    return true;
}
static_assert(in_enum_order(formats) && in_enum_order(codecs));
static_assert(std::size(formats) == std::size(codecs));

// Texels a task: large enough that starting one costs nothing beside it.
constexpr size_t chunk_texels = 8192;

int chunks_of(size_t texels) {
    return static_cast<int>((texels + chunk_texels - 1) / chunk_texels);
}

struct Chunk {
    size_t first;
    size_t count;
};

Chunk chunk_at(int index, size_t texels) {
    const size_t first = static_cast<size_t>(index) * chunk_texels;
    return {first, std::min(chunk_texels, texels - first)};
}

}  // namespace

std::span<const PixelFormatInfo> pixel_formats() { return formats; }

const PixelFormatInfo& info_of(PixelFormat format) { return formats[static_cast<size_t>(format)]; }

const PixelFormatInfo* find_pixel_format(std::string_view name) {
    const auto found = std::ranges::find(formats, name, &PixelFormatInfo::name);
    return found == std::end(formats) ? nullptr : found;
}

bool holds_colours(const PixelFormatInfo& info) { return info.channels >= 3; }
bool holds_tables(const PixelFormatInfo& info) { return info.channels != 3; }

EncodeCounts encode_texels(PixelFormat format, int channel_count, std::span<const float> values,
                           std::span<std::byte> bytes) {
    const PixelFormatInfo& info = info_of(format);
    assert(channel_count >= 1 && channel_count <= info.channels);
    const auto channels = static_cast<size_t>(channel_count);
    const auto stride = static_cast<size_t>(info.bytes_per_texel);
    const size_t texels = values.size() / channels;
    assert(values.size() == texels * channels && bytes.size() == texels * stride);
    const auto encode = codecs[static_cast<size_t>(format)].encode;
    return ordered_sum(chunks_of(texels), [&](int index) {
        const Chunk chunk = chunk_at(index, texels);
        return encode(info, channel_count, values.data() + chunk.first * channels,
                      bytes.data() + chunk.first * stride, chunk.count);
    });
}

void decode_texels(PixelFormat format, int channel_count, std::span<const std::byte> bytes,
                   std::span<float> values) {
    const PixelFormatInfo& info = info_of(format);
    assert(channel_count >= 1 && channel_count <= info.channels);
    const auto channels = static_cast<size_t>(channel_count);
    const auto stride = static_cast<size_t>(info.bytes_per_texel);
    const size_t texels = bytes.size() / stride;
    assert(bytes.size() == texels * stride && values.size() == texels * channels);
    const auto decode = codecs[static_cast<size_t>(format)].decode;
    parallel_rows(chunks_of(texels), [&](int index) {
        const Chunk chunk = chunk_at(index, texels);
        decode(info, channel_count, bytes.data() + chunk.first * stride,
               values.data() + chunk.first * channels, chunk.count);
    });
}

}  // namespace splitsum
