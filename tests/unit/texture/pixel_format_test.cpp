#include "splitsum/texture/pixel_format.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "splitsum/base/parallel.h"
#include "splitsum/base/random.h"

namespace splitsum {
namespace {

// As a cubemap or a table fills it: alpha is left out.
int channels_of(const PixelFormatInfo& info) { return std::min(3, info.channels); }

// What the format makes of `values`, through the stored bytes.
std::vector<float> round_trip(PixelFormat format, const std::vector<float>& values,
                              EncodeCounts* counts = nullptr) {
    const PixelFormatInfo& info = info_of(format);
    std::vector<std::byte> bytes(values.size() / channels_of(info) * info.bytes_per_texel);
    const EncodeCounts found = encode_texels(format, channels_of(info), values, bytes);
    if (counts) *counts = found;
    std::vector<float> back(values.size());
    decode_texels(format, channels_of(info), bytes, back);
    return back;
}

template <class Stored>
std::vector<float> decoded(PixelFormat format, const std::vector<Stored>& stored) {
    const auto bytes = std::as_bytes(std::span(stored));
    const PixelFormatInfo& info = info_of(format);
    std::vector<float> values(bytes.size() / info.bytes_per_texel * channels_of(info));
    decode_texels(format, channels_of(info), bytes, values);
    return values;
}

template <class Stored>
std::vector<Stored> encoded(PixelFormat format, const std::vector<float>& values) {
    const PixelFormatInfo& info = info_of(format);
    std::vector<Stored> stored(values.size() / channels_of(info) * info.bytes_per_texel /
                               sizeof(Stored));
    encode_texels(format, channels_of(info), values, std::as_writable_bytes(std::span(stored)));
    return stored;
}

// `count` radiances from 2^-30 to 2^17, evenly in the logarithm: every format's denormals, its
// normal range and what is too large for it.
std::vector<float> radiances(size_t count, uint32_t seed) {
    std::vector<float> values(count);
    for (uint32_t i = 0; i < count; ++i)
        values[i] = std::exp2(-30 + 47 * unit_float(mix_bits(i) ^ seed));
    return values;
}

TEST(PixelFormat, NamesFindTheirFormat) {
    ASSERT_EQ(pixel_formats().size(), 7u);
    for (const PixelFormatInfo& info : pixel_formats()) {
        EXPECT_EQ(find_pixel_format(info.name), &info) << info.name;
        EXPECT_EQ(&info_of(info.format), &info) << info.name;
    }
    EXPECT_EQ(find_pixel_format("rgba8"), nullptr);
}

TEST(PixelFormat, EveryFiniteHalfComesBackBitForBit) {
    for (const auto format : {PixelFormat::rg16f, PixelFormat::rgba16f}) {
        const size_t stored_channels = format == PixelFormat::rg16f ? 2 : 4;
        for (uint32_t bits = 0; bits < 0x10000; ++bits) {
            if ((bits & 0x7c00) == 0x7c00) continue;  // Inf and NaN are never stored
            std::vector<uint16_t> stored(stored_channels, static_cast<uint16_t>(bits));
            if (stored_channels == 4) stored[3] = 0x3c00;
            EXPECT_EQ(encoded<uint16_t>(format, decoded(format, stored)), stored) << bits;
        }
    }
}

TEST(PixelFormat, EverySmallFloatComesBackBitForBit) {
    for (uint32_t bits = 0; bits < 0x7c0; ++bits) {
        const std::vector<uint32_t> stored = {bits, bits << 11, std::min(bits, 0x3dfu) << 22};
        EXPECT_EQ(
            encoded<uint32_t>(PixelFormat::b10g11r11, decoded(PixelFormat::b10g11r11, stored)),
            stored)
            << bits;
    }
}

TEST(PixelFormat, SharedExponentValuesComeBack) {
    // Texels with a mantissa of 256 or more are the only way to write their values.
    for (uint32_t exponent = 0; exponent < 32; ++exponent)
        for (uint32_t mantissa = 256; mantissa < 512; ++mantissa) {
            const std::vector<uint32_t> stored = {exponent << 27 | (mantissa / 3) << 18 |
                                                  (mantissa / 7) << 9 | mantissa};
            EXPECT_EQ(encoded<uint32_t>(PixelFormat::rgb9e5, decoded(PixelFormat::rgb9e5, stored)),
                      stored)
                << exponent << " " << mantissa;
        }
}

// Known bits of each format, one different colour a channel: red 1, green 2, blue 4 (Vulkan's
// layouts, lowest bits first).
TEST(PixelFormat, ChannelsLieWhereVulkanPutsThem) {
    const std::vector<float> colour = {1, 2, 4};
    EXPECT_EQ(encoded<uint16_t>(PixelFormat::rgba16f, colour),
              (std::vector<uint16_t>{0x3c00, 0x4000, 0x4400, 0x3c00}));
    EXPECT_EQ(encoded<float>(PixelFormat::rgba32f, colour), (std::vector<float>{1, 2, 4, 1}));
    EXPECT_EQ(encoded<uint32_t>(PixelFormat::b10g11r11, colour),
              (std::vector<uint32_t>{15u << 6 | 16u << 17 | 17u << 27}));
    // Exponent 18 for 4 = 256 * 2^(18 - 24); 1 and 2 are 64 and 128 of the same unit.
    EXPECT_EQ(encoded<uint32_t>(PixelFormat::rgb9e5, colour),
              (std::vector<uint32_t>{64u | 128u << 9 | 256u << 18 | 18u << 27}));
    EXPECT_EQ(encoded<uint16_t>(PixelFormat::rg16f, {1, 2}),
              (std::vector<uint16_t>{0x3c00, 0x4000}));
    EXPECT_EQ(encoded<float>(PixelFormat::rg32f, {1, 2}), (std::vector<float>{1, 2}));
}

// Nearest: no neighbour in the format is closer; on a tie the last mantissa bit is 0. Caught when
// tried: truncation, ties away from 0, denormals flushed.
void expect_nearest(PixelFormat format, int channel, float value, float stored, float below,
                    float above, bool last_bit) {
    const double error = std::abs(double{stored} - value);
    const double error_below = std::abs(double{below} - value);
    const double error_above = std::abs(double{above} - value);
    EXPECT_LE(error, error_below) << info_of(format).name << channel << " " << value;
    EXPECT_LE(error, error_above) << info_of(format).name << channel << " " << value;
    if (error == error_below || error == error_above) {
        EXPECT_FALSE(last_bit) << value;
    }
}

// The values to try around every stored value: itself, the ties and their neighbours.
std::vector<float> probes_around(float below, float stored, float above) {
    std::vector<float> probes = {stored};
    for (const float other : {below, above}) {
        const auto tie = static_cast<float>((double{stored} + other) / 2);
        probes.insert(probes.end(), {tie, std::nextafter(tie, 0.0f), std::nextafter(tie, 1e6f)});
    }
    return probes;
}

TEST(PixelFormat, HalfsRoundToNearestEven) {
    const auto value_of = [](uint32_t bits) {
        const auto half = static_cast<uint16_t>(bits);
        return decoded<uint16_t>(PixelFormat::rg16f, {half, half})[0];
    };
    for (uint32_t bits = 1; bits < 0x7bff; ++bits) {
        for (const float probe :
             probes_around(value_of(bits - 1), value_of(bits), value_of(bits + 1))) {
            const auto half = encoded<uint16_t>(PixelFormat::rg16f, {probe, -probe});
            ASSERT_EQ(half[1], half[0] | 0x8000);
            if (half[0] == 0 || half[0] == 0x7bff) continue;
            expect_nearest(PixelFormat::rg16f, 0, probe, value_of(half[0]), value_of(half[0] - 1u),
                           value_of(half[0] + 1u), half[0] & 1);
        }
    }
}

TEST(PixelFormat, SmallFloatsRoundToNearestEven) {
    struct Channel {
        int shift;
        uint32_t largest;
    };
    const Channel channels[] = {{0, 0x7bf}, {11, 0x7bf}, {22, 0x3df}};
    for (int c = 0; c < 3; ++c) {
        const auto value_of = [&](uint32_t bits) {
            return decoded<uint32_t>(PixelFormat::b10g11r11, {bits << channels[c].shift})[c];
        };
        for (uint32_t bits = 1; bits < channels[c].largest; ++bits)
            for (const float probe :
                 probes_around(value_of(bits - 1), value_of(bits), value_of(bits + 1))) {
                std::vector<float> colour(3);
                colour[c] = probe;
                const uint32_t texel = encoded<uint32_t>(PixelFormat::b10g11r11, colour)[0];
                const uint32_t found = texel >> channels[c].shift;
                ASSERT_EQ(found << channels[c].shift, texel) << "another channel was touched";
                if (found == 0 || found == channels[c].largest) continue;
                expect_nearest(PixelFormat::b10g11r11, c, probe, value_of(found),
                               value_of(found - 1), value_of(found + 1), found & 1);
            }
    }
}

// Each channel is the nearest multiple of the texel's unit, and the unit is the smallest with which
// the largest channel fits in 9 bits. 511.5 units and more of the largest channel need the next
// exponent (caught when tried: without that case the mantissa overflows into its neighbour).
TEST(PixelFormat, SharedExponentRoundsToTheNearestOfTheSmallestUnit) {
    std::vector<float> colours = radiances(3 * 50'000, 1);
    for (float& value : colours) value = std::min(value, 65408.0f);
    for (int e = -14; e < 15; ++e)  // around the carry
        for (const double mantissa : {511.25, 511.49999, 511.5, 511.50001, 511.75})
            colours.insert(colours.end(),
                           {static_cast<float>(std::ldexp(mantissa, e - 9)),
                            static_cast<float>(std::ldexp(100.5, e - 9)), std::ldexp(0.3f, e)});
    const auto texels = encoded<uint32_t>(PixelFormat::rgb9e5, colours);
    for (size_t i = 0; i < texels.size(); ++i) {
        const auto exponent = static_cast<int>(texels[i] >> 27);
        double largest = 0;
        for (size_t c = 0; c < 3; ++c) {
            const double in_units = std::ldexp(double{colours[3 * i + c]}, 24 - exponent);
            EXPECT_EQ((texels[i] >> (9 * c)) & 511, std::floor(in_units + 0.5))
                << colours[3 * i + c];
            largest = std::max(largest, in_units);
        }
        if (exponent > 0) {
            EXPECT_GE(std::floor(2 * largest + 0.5), 512) << "a smaller unit would do";
        }
    }
}

TEST(PixelFormat, FloatFormatsKeepEveryFiniteValue) {
    const float largest = std::numeric_limits<float>::max();
    const std::vector<float> values = {largest, -largest, 1e-45f, -0.0f, 65505, 1.0f / 3};
    for (const auto format : {PixelFormat::rgba32f, PixelFormat::rg32f}) {
        EncodeCounts counts;
        const auto back = round_trip(format, values, &counts);
        EXPECT_EQ(std::memcmp(back.data(), values.data(), values.size() * sizeof(float)), 0);
        EXPECT_EQ(counts.saturated + counts.negative, 0);
    }
}

TEST(PixelFormat, WhatIsTooLargeIsStoredAsTheLargestAndCounted) {
    for (const PixelFormatInfo& info : pixel_formats()) {
        std::vector<float> fits(info.largest.begin(), info.largest.begin() + channels_of(info));
        EncodeCounts counts;
        EXPECT_EQ(round_trip(info.format, fits, &counts), fits) << info.name;
        EXPECT_EQ(counts.saturated, 0) << info.name;

        for (int c = 0; c < channels_of(info); ++c) {
            std::vector<float> sun(channels_of(info));
            sun[c] = std::nextafter(info.largest[c], std::numeric_limits<float>::infinity());
            std::vector<float> expected(channels_of(info));
            expected[c] = info.largest[c];
            EXPECT_EQ(round_trip(info.format, sun, &counts), expected) << info.name << c;
            EXPECT_EQ(counts.saturated, 1) << info.name << c;
        }
    }
    EncodeCounts counts;
    const auto back = round_trip(PixelFormat::rgba16f, {1e9f, -1e9f, 5}, &counts);
    EXPECT_EQ(back, (std::vector<float>{65504, -65504, 5}));
    EXPECT_EQ(counts.saturated, 2);
    EXPECT_EQ(counts.negative, 0);
}

TEST(PixelFormat, NegativesBecomeZeroWhereThereIsNoSignAndAreCounted) {
    for (const auto format : {PixelFormat::rgb9e5, PixelFormat::b10g11r11}) {
        EncodeCounts counts;
        const auto back = round_trip(format, {-1, 2, -1e9f, -0.0f, 0, 1}, &counts);
        EXPECT_EQ(back, (std::vector<float>{0, 2, 0, 0, 0, 1})) << info_of(format).name;
        EXPECT_EQ(counts.negative, 2) << info_of(format).name;
        EXPECT_EQ(counts.saturated, 0) << info_of(format).name;
    }
    EncodeCounts counts;
    const auto back = round_trip(PixelFormat::rgba16f, {-1, 2, -0.5f}, &counts);
    EXPECT_EQ(back, (std::vector<float>{-1, 2, -0.5f}));
    EXPECT_EQ(counts.negative, 0);
}

// More texels than a task takes, and not a multiple of it.
TEST(PixelFormat, BytesAndCountsDoNotDependOnThreads) {
    std::vector<float> colours = radiances(3 * 30'001, 2);
    for (size_t i = 0; i < colours.size(); i += 17) colours[i] = -colours[i];
    for (const PixelFormatInfo& info : pixel_formats()) {
        if (!holds_colours(info)) continue;
        const auto run = [&](int threads, EncodeCounts& counts) {
            const ThreadLimit limit(threads);
            return round_trip(info.format, colours, &counts);
        };
        EncodeCounts alone, together;
        EXPECT_EQ(run(1, alone), run(8, together)) << info.name;
        EXPECT_EQ(alone.saturated, together.saturated) << info.name;
        EXPECT_EQ(alone.negative, together.negative) << info.name;
        EXPECT_GT(alone.saturated + (info.format == PixelFormat::rgba32f), 0) << info.name;
    }
}

// Every 65535th, its neighbours just short of and just past the tie, and what lies outside.
TEST(PixelFormat, UnormsRoundToTheNearestAndAreCountedOutside) {
    std::vector<float> values;
    for (int i = 0; i <= 65535; i += 3)
        for (const double off : {0.0, -0.49, 0.49})
            values.push_back(std::clamp(static_cast<float>((i + off) / 65535), 0.0F, 1.0F));
    if (values.size() % 2 != 0) values.push_back(0);
    const auto back = round_trip(PixelFormat::rg16unorm, values);
    for (size_t i = 0; i < values.size(); ++i)
        ASSERT_NEAR(back[i], values[i], 0.495 / 65535) << values[i];
    EncodeCounts counts;
    EXPECT_EQ(round_trip(PixelFormat::rg16unorm, {-0.25F, 1.5F, 0, 1}, &counts),
              (std::vector<float>{0, 1, 0, 1}));
    EXPECT_EQ(counts.negative, 1);
    EXPECT_EQ(counts.saturated, 1);
}

// What a shader reads of channels that a texture does not have: 0, and 1 for alpha.
TEST(PixelFormat, AbsentChannelsAreZeroAndAlphaOne) {
    for (const PixelFormatInfo& info : pixel_formats())
        for (int channels = 1; channels <= info.channels; ++channels) {
            const std::vector<float> values(static_cast<size_t>(channels), 0.25F);
            std::vector<std::byte> bytes(static_cast<size_t>(info.bytes_per_texel));
            encode_texels(info.format, channels, values, bytes);
            std::vector<float> back(static_cast<size_t>(info.channels));
            decode_texels(info.format, info.channels, bytes, back);
            const float absent[] = {0, 0, 0, 1};
            for (int c = 0; c < info.channels; ++c)
                EXPECT_NEAR(back[size_t(c)], c < channels ? 0.25F : absent[c], 1e-5F)
                    << info.name << " " << channels;
        }
}

}  // namespace
}  // namespace splitsum
