#include "splitsum/container/dds.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <string>

#include "unit/container/sample_textures.h"

namespace splitsum {
namespace {

using Bytes = std::vector<std::byte>;

// Offsets of Microsoft's structures, written here a second time on purpose.
constexpr size_t size_at = 4, flags_at = 8, height_at = 12, width_at = 16, pitch_at = 20,
                 depth_at = 24, levels_at = 28, format_size_at = 76, format_flags_at = 80,
                 four_cc_at = 84, caps_at = 108, caps2_at = 112, dxgi_at = 128, dimension_at = 132,
                 misc_at = 136, array_at = 140;
constexpr uint32_t dx10 = 0x30315844;

uint32_t word(const Bytes& file, size_t offset) {
    uint32_t value;
    std::memcpy(&value, file.data() + offset, sizeof value);
    return value;
}

void set(Bytes& file, size_t offset, uint32_t value) {
    std::memcpy(file.data() + offset, &value, sizeof value);
}

Bytes encoded(const TextureAsset& texture) {
    auto file = encode_dds(texture);
    EXPECT_TRUE(file) << file.error().message;
    return *file;
}

TextureAsset sample(const PixelFormatInfo& info) {
    return holds_colours(info) ? sample_cube(info.format) : sample_table(info.format);
}

std::string outcome(const Bytes& file) {
    const auto texture = decode_dds(file);
    if (texture) return "read";
    return texture.error().kind == ErrorKind::unreadable_input ? "unreadable"
           : texture.error().kind == ErrorKind::unusable_input ? "unusable"
                                                               : "another error";
}

std::string outcome_after(Bytes file, size_t offset, uint32_t value) {
    set(file, offset, value);
    return outcome(file);
}

TEST(Dds, EveryFormatComesBackWithoutItsMetadata) {
    for (const PixelFormatInfo& info : pixel_formats()) {
        const TextureAsset texture = sample(info);
        const auto back = decode_dds(encoded(texture));
        ASSERT_TRUE(back) << info.name << ": " << back.error().message;
        EXPECT_TRUE(same_texels(*back, texture)) << info.name;
        EXPECT_TRUE(back->metadata.empty());
    }
}

TEST(Dds, HalfFloatsAndFloatsHaveTheHeaderThatEveryReaderKnows) {
    const std::pair<PixelFormat, uint32_t> codes[] = {{PixelFormat::rgba16f, 113},
                                                      {PixelFormat::rgba32f, 116},
                                                      {PixelFormat::rg16f, 112},
                                                      {PixelFormat::rg32f, 115}};
    for (const auto& [format, code] : codes) {
        const TextureAsset texture = sample(info_of(format));
        const Bytes file = encoded(texture);
        const bool cube = texture.face_count == 6;
        EXPECT_EQ(std::memcmp(file.data(), "DDS ", 4), 0);
        EXPECT_EQ(word(file, size_at), 124u);
        EXPECT_EQ(word(file, flags_at), cube ? 0x2100fu : 0x100fu);
        EXPECT_EQ(word(file, height_at), static_cast<uint32_t>(texture.height));
        EXPECT_EQ(word(file, width_at), static_cast<uint32_t>(texture.width));
        EXPECT_EQ(word(file, pitch_at),
                  static_cast<uint32_t>(texture.width * info_of(format).bytes_per_texel));
        EXPECT_EQ(word(file, levels_at), texture.levels.size());
        EXPECT_EQ(word(file, format_size_at), 32u);
        EXPECT_EQ(word(file, format_flags_at), 4u);
        EXPECT_EQ(word(file, four_cc_at), code);
        EXPECT_EQ(word(file, caps_at), cube ? 0x401008u : 0x1000u);
        EXPECT_EQ(word(file, caps2_at), cube ? 0xfe00u : 0u);
    }
}

TEST(Dds, OtherFormatsAndArraysHaveTheSecondHeader) {
    const std::pair<PixelFormat, uint32_t> codes[] = {
        {PixelFormat::rgb9e5, 67}, {PixelFormat::b10g11r11, 26}, {PixelFormat::rg16unorm, 35}};
    for (const auto& [format, code] : codes) {
        const TextureAsset texture = sample(info_of(format));
        const Bytes file = encoded(texture);
        EXPECT_EQ(word(file, four_cc_at), dx10);
        EXPECT_EQ(word(file, dxgi_at), code);
        EXPECT_EQ(word(file, dimension_at), 3u);
        EXPECT_EQ(word(file, misc_at), texture.face_count == 6 ? 4u : 0u);
        EXPECT_EQ(word(file, array_at), 1u);
    }
    const Bytes array = encoded(sample_table(PixelFormat::rg32f, 2, 3));
    EXPECT_EQ(word(array, four_cc_at), dx10);
    EXPECT_EQ(word(array, dxgi_at), 16u);
    EXPECT_EQ(word(array, array_at), 3u);
}

// Microsoft's order is by face first, unlike that of KTX 2.
TEST(Dds, EachFaceHasAllItsLevels) {
    const TextureAsset texture = sample_cube(PixelFormat::rgba32f, 4, 3);
    const Bytes file = encoded(texture);
    size_t at = 128;
    for (int face = 0; face < 6; ++face)
        for (int level = 0; level < 3; ++level) {
            const int size = 4 >> level;
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < size; ++x, at += 16) {
                    float texel[4];
                    std::memcpy(texel, file.data() + at, sizeof texel);
                    EXPECT_EQ(texel[0], static_cast<float>(face + 1));
                    EXPECT_EQ(texel[1], static_cast<float>(x + 1));
                    EXPECT_EQ(texel[2], static_cast<float>(y + 1 + 16 * level));
                    EXPECT_EQ(texel[3], 1.0f);
                }
        }
    EXPECT_EQ(at, file.size());
}

TEST(Dds, KeepsTheLayersOfAnArray) {
    for (const PixelFormatInfo& info : pixel_formats()) {
        if (!holds_tables(info)) continue;
        const TextureAsset texture = sample_table(info.format, info.channels, 3);
        const auto back = decode_dds(encoded(texture));
        ASSERT_TRUE(back) << back.error().message;
        EXPECT_TRUE(same_texels(*back, texture)) << info.name;
    }
}

// Flags that Microsoft tells readers not to rely on, and both headers for one format.
TEST(Dds, ReadsWhatOtherWritersWrite) {
    const TextureAsset texture = sample_cube(PixelFormat::rgba16f);
    Bytes file = encoded(texture);
    set(file, flags_at, 0);
    set(file, caps_at, 0);
    set(file, pitch_at, 0);
    EXPECT_TRUE(same_texels(*decode_dds(file), texture));

    const uint32_t second[] = {10, 3, 4, 1, 0};
    const auto* bytes = reinterpret_cast<const std::byte*>(second);
    file.insert(file.begin() + 128, bytes, bytes + sizeof second);
    set(file, four_cc_at, dx10);
    EXPECT_TRUE(same_texels(*decode_dds(file), texture));

    Bytes single = encoded(sample_table(PixelFormat::rg16f));
    set(single, levels_at, 0);
    EXPECT_EQ(outcome(single), "read");
}

TEST(Dds, EveryPrefixIsUnreadable) {
    for (const auto format : {PixelFormat::rgba16f, PixelFormat::rgb9e5}) {
        const Bytes file = encoded(sample_cube(format, 4, 3));
        for (size_t length = 0; length < file.size(); ++length) {
            const auto texture = decode_dds(std::span(file).first(length));
            ASSERT_FALSE(texture) << length << " of " << file.size();
            ASSERT_EQ(texture.error().kind, ErrorKind::unreadable_input) << length;
        }
    }
}

// No byte may lead the reader out of the file: with the address sanitizer this is a proof of sorts.
TEST(Dds, AnyChangedByteIsReadOrRefused) {
    for (const auto format : {PixelFormat::rgba16f, PixelFormat::b10g11r11}) {
        const Bytes good = encoded(sample_cube(format, 2, 2));
        for (size_t i = 0; i < good.size(); ++i)
            for (const int change : {1, 0x80, 0xff}) {
                Bytes file = good;
                file[i] ^= static_cast<std::byte>(change);
                if (const auto texture = decode_dds(file)) {
                    EXPECT_TRUE(validate(*texture)) << i;
                }
            }
    }
}

TEST(Dds, RefusesWhatContradictsItself) {
    const Bytes good = encoded(sample_cube(PixelFormat::rgb9e5));
    ASSERT_EQ(outcome(good), "read");
    EXPECT_EQ(outcome_after(good, 0, 0x12345678), "unreadable");
    EXPECT_EQ(outcome_after(good, size_at, 125), "unreadable");
    EXPECT_EQ(outcome_after(good, format_size_at, 24), "unreadable");
    EXPECT_EQ(outcome_after(good, width_at, 0), "unreadable");
    EXPECT_EQ(outcome_after(good, width_at, 16), "unreadable") << "faces that are not square";
    EXPECT_EQ(outcome_after(good, levels_at, 5), "unreadable");
    EXPECT_EQ(outcome_after(good, levels_at, 0xffffffff), "unreadable");
    EXPECT_EQ(outcome_after(good, levels_at, 3), "unreadable") << "bytes are left";
    EXPECT_EQ(outcome_after(good, array_at, 0), "unreadable");
    Bytes longer = good;
    longer.push_back(std::byte{});
    EXPECT_EQ(outcome(longer), "unreadable");
    Bytes absurd = good;
    set(absurd, width_at, 0xffffffff);
    set(absurd, height_at, 0xffffffff);
    EXPECT_EQ(outcome(absurd), "unreadable");
}

TEST(Dds, RefusesOtherKindsOfTexture) {
    const Bytes modern = encoded(sample_cube(PixelFormat::rgb9e5));
    EXPECT_EQ(outcome_after(modern, dxgi_at, 95), "unusable") << "BC6H";
    EXPECT_EQ(outcome_after(modern, dimension_at, 2), "unusable") << "1D";
    EXPECT_EQ(outcome_after(modern, dimension_at, 4), "unusable") << "3D";
    EXPECT_EQ(outcome_after(modern, array_at, 2), "unusable") << "array of cubemaps";
    const Bytes legacy = encoded(sample_cube(PixelFormat::rgba16f));
    EXPECT_EQ(outcome_after(legacy, four_cc_at, 0x31545844), "unusable") << "DXT1";
    EXPECT_EQ(outcome_after(legacy, four_cc_at, 0), "unusable");
    EXPECT_EQ(outcome_after(legacy, format_flags_at, 0x41), "unusable") << "bit masks";
    EXPECT_EQ(outcome_after(legacy, caps2_at, 0xbe00), "unusable") << "five faces";
    EXPECT_EQ(outcome_after(legacy, caps2_at, 0x20fe00), "unusable") << "volume";
    Bytes deep = legacy;
    set(deep, flags_at, word(deep, flags_at) | 0x800000);
    set(deep, depth_at, 4);
    EXPECT_EQ(outcome(deep), "unusable");
}

TEST(Dds, RefusesSizesThatNoMemoryHolds) {
    Bytes file = encoded(sample_cube(PixelFormat::rgba16f, 4, 1));
    set(file, width_at, 32768);
    set(file, height_at, 32768);
    EXPECT_EQ(outcome(file), "unusable") << "51 GB of texels";
}

TEST(Dds, RefusesWhatItCannotStore) {
    TextureAsset texture = sample_table(PixelFormat::rg16f);
    texture.levels[0].pop_back();
    EXPECT_EQ(encode_dds(texture).error().kind, ErrorKind::bad_argument);
}

TEST(Dds, ErrorsNameTheFile) {
    const auto path = std::filesystem::path(testing::TempDir()) / "sample.dds";
    ASSERT_TRUE(write_dds(sample_cube(PixelFormat::rgba32f), path));
    std::filesystem::resize_file(path, 100);
    const auto texture = read_dds(path);
    ASSERT_FALSE(texture);
    EXPECT_EQ(texture.error().kind, ErrorKind::unreadable_input);
    EXPECT_NE(texture.error().message.find(path.string()), std::string::npos);
}

}  // namespace
}  // namespace splitsum
