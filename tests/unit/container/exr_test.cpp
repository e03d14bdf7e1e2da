#include <OpenEXR/ImfEnvmap.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfTiledInputFile.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "splitsum/container/exr_cube.h"
#include "splitsum/container/exr_table.h"
#include "unit/container/sample_textures.h"

namespace splitsum {
namespace {

using Bytes = std::vector<std::byte>;

std::filesystem::path temporary(const char* name) {
    return std::filesystem::path(testing::TempDir()) / name;
}

// The colour of a texel is the direction of its centre, brought to [1, 2]: lopsided everywhere.
Cubemap direction_sky(int face_size) {
    Cubemap sky(face_size);
    for (int face = 0; face < face_count; ++face)
        for (int y = 0; y < face_size; ++y)
            for (int x = 0; x < face_size; ++x)
                sky.at(face, x, y) = Vec3(1.5 + 0.5 * direction_of_texel(face, x, y, face_size));
    return sky;
}

TEST(ExrCube, ComesBackWithItsMetadata) {
    for (const auto format : {PixelFormat::rgba16f, PixelFormat::rgba32f})
        for (const int levels : {1, 2, 4}) {
            const TextureAsset texture = sample_cube(format, 8, levels);
            const auto file = encode_exr_cube(texture);
            ASSERT_TRUE(file) << file.error().message;
            const auto back = decode_exr_cube(*file);
            ASSERT_TRUE(back) << back.error().message;
            EXPECT_TRUE(same_texels(*back, texture)) << levels;
            EXPECT_EQ(back->metadata, texture.metadata);
        }
    const TextureAsset odd = sample_cube(PixelFormat::rgba16f, 7, 1);
    const auto back = decode_exr_cube(*encode_exr_cube(odd));
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_TRUE(same_texels(*back, odd));
}

// OpenEXR's own functions find a direction's colour in the file, on every level. Where they look is
// up to half a texel beside our centres (see exr_cube.h), which bounds the difference. Caught when
// tried: any face not turned, faces swapped.
TEST(ExrCube, OpenExrFindsTheRadianceOfADirection) {
    constexpr int size = 64, levels = 5;
    std::vector<Cubemap> skies;
    for (int level = 0; level < levels; ++level) skies.push_back(direction_sky(size >> level));
    std::vector<EncodeCounts> counts;
    const auto path = temporary("direction.exr");
    ASSERT_TRUE(write_exr_cube(texture_from_cubemaps(skies, PixelFormat::rgba32f, counts), path));

    Imf::TiledInputFile file(path.c_str());
    ASSERT_TRUE(Imf::hasEnvmap(file.header()));
    ASSERT_EQ(Imf::envmap(file.header()), Imf::ENVMAP_CUBE);
    for (int level = 0; level < levels; ++level) {
        const Imath::Box2i window = file.dataWindowForLevel(level);
        const int width = size >> level;
        ASSERT_EQ(window.max, Imath::V2i(width - 1, 6 * width - 1));
        std::vector<float> rgb(3 * static_cast<size_t>(width) * static_cast<size_t>(6 * width));
        Imf::FrameBuffer buffer;
        for (const int c : {0, 1, 2})
            buffer.insert(std::string(1, "RGB"[c]),
                          Imf::Slice::Make(Imf::FLOAT, rgb.data() + c, window, 12, 12 * width));
        file.setFrameBuffer(buffer);
        file.readTiles(0, file.numXTiles(level) - 1, 0, file.numYTiles(level) - 1, level);

        double worst = 0;
        for (int i = 0; i < 2000; ++i) {
            const double z = 1 - (2 * i + 1) / 2000.0, phi = 2.399963 * i;
            const double r = std::sqrt(1 - z * z);
            const Imath::V3f direction(static_cast<float>(r * std::cos(phi)),
                                       static_cast<float>(r * std::sin(phi)),
                                       static_cast<float>(z));
            Imf::CubeMapFace face;
            Imath::V2f in_face;
            Imf::CubeMap::faceAndPixelPosition(direction, window, face, in_face);
            const Imath::V2f at = Imf::CubeMap::pixelPosition(face, window, in_face);
            const auto pixel =
                3 * (static_cast<size_t>(std::lround(at.y)) * static_cast<size_t>(width) +
                     static_cast<size_t>(std::lround(at.x)));
            for (int c = 0; c < 3; ++c)
                worst = std::max(worst, std::abs(2.0 * (rgb[pixel + c] - 1.5) - direction[c]));
        }
        // Half a texel of rounding and up to half of OpenEXR's own placement, along each axis.
        EXPECT_LT(worst, 2.0 / width) << "level " << level;
    }
}

// The format wants levels down to 1x1; behind ours come averages, so no reader finds a hole.
TEST(ExrCube, EveryLevelOfTheFileIsThere) {
    const auto path = temporary("levels.exr");
    ASSERT_TRUE(write_exr_cube(sample_cube(PixelFormat::rgba32f, 8, 2), path));
    Imf::TiledInputFile file(path.c_str());
    EXPECT_TRUE(file.isComplete());
    ASSERT_EQ(file.numLevels(), 6);  // of 8 x 48
    float red = 0;
    Imf::FrameBuffer buffer;
    buffer.insert("R", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(&red), 4, 4));
    file.setFrameBuffer(buffer);
    file.readTile(0, 0, 5);
    EXPECT_FLOAT_EQ(red, 3.5f) << "the mean of the faces' numbers";
}

TEST(ExrCube, RefusesWhatItCannotStore) {
    const auto refusal = [](const TextureAsset& texture) {
        const auto file = encode_exr_cube(texture);
        return file || file.error().kind != ErrorKind::bad_argument ? "" : file.error().message;
    };
    for (const auto format : {PixelFormat::rgb9e5, PixelFormat::b10g11r11}) {
        const std::string message = refusal(sample_cube(format));
        EXPECT_NE(message.find(info_of(format).name), std::string::npos) << message;
        EXPECT_NE(message.find("rgba16f or rgba32f"), std::string::npos) << message;
    }
    EXPECT_NE(refusal(sample_cube(PixelFormat::rgba16f, 6, 2)), "");
    EXPECT_EQ(refusal(sample_cube(PixelFormat::rgba16f, 6, 1)), "");
    EXPECT_NE(refusal(sample_table(PixelFormat::rg16f)), "");
    for (const char* key : {"compression", "envmap", "tiles", "splitsum.exr.levels", ""}) {
        TextureAsset texture = sample_cube(PixelFormat::rgba16f);
        texture.metadata[key] = "ours";
        EXPECT_NE(refusal(texture), "") << key;
    }
}

TEST(ExrCube, KeysOfKtxStayInKtx) {
    TextureAsset texture = sample_cube(PixelFormat::rgba16f);
    texture.metadata["KTXorientation"] = "rd";
    const auto back = decode_exr_cube(*encode_exr_cube(texture));
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_FALSE(back->metadata.contains("KTXorientation"));
}

TEST(ExrTable, ComesBackWithItsMetadata) {
    for (const auto format : {PixelFormat::rg16f, PixelFormat::rg32f}) {
        const TextureAsset texture = sample_table(format);
        const auto path = temporary("table.exr");
        ASSERT_TRUE(write_exr_table(texture, path));
        const auto back = read_exr_table(path);
        ASSERT_TRUE(back) << back.error().message;
        EXPECT_TRUE(same_texels(*back, texture));
        EXPECT_EQ(back->metadata, texture.metadata);
    }
    EXPECT_FALSE(encode_exr_table(sample_cube(PixelFormat::rgba16f)));
    EXPECT_FALSE(encode_exr_table(sample_table(PixelFormat::rg16unorm)));
}

TEST(ExrTable, KeepsChannelsAndLayers) {
    for (const auto format :
         {PixelFormat::rg16f, PixelFormat::rg32f, PixelFormat::rgba16f, PixelFormat::rgba32f})
        for (const int layers : {1, 2, 3}) {
            const TextureAsset texture = sample_table(format, info_of(format).channels, layers);
            const auto file = encode_exr_table(texture);
            ASSERT_TRUE(file) << file.error().message;
            const auto back = decode_exr_table(*file);
            ASSERT_TRUE(back) << back.error().message;
            EXPECT_TRUE(same_texels(*back, texture)) << info_of(format).name << " " << layers;
        }
}

TEST(Exr, EveryPrefixIsUnreadable) {
    const Bytes cube = *encode_exr_cube(sample_cube(PixelFormat::rgba16f, 4, 2));
    for (size_t length = 0; length < cube.size(); ++length) {
        const auto texture = decode_exr_cube(std::span(cube).first(length));
        ASSERT_FALSE(texture) << length << " of " << cube.size();
        ASSERT_EQ(texture.error().kind, ErrorKind::unreadable_input) << texture.error().message;
    }
    const Bytes table = *encode_exr_table(sample_table(PixelFormat::rg16f));
    for (size_t length = 0; length < table.size(); ++length)
        ASSERT_FALSE(decode_exr_table(std::span(table).first(length))) << length;
}

TEST(Exr, AnyChangedByteIsReadOrRefused) {
    const auto check = [](const Bytes& good, auto decode) {
        for (size_t i = 0; i < good.size(); ++i)
            for (const int change : {1, 0x80, 0xff}) {
                Bytes file = good;
                file[i] ^= static_cast<std::byte>(change);
                const auto texture = decode(file);
                if (texture) {
                    EXPECT_TRUE(validate(*texture)) << i;
                }
            }
    };
    check(*encode_exr_cube(sample_cube(PixelFormat::rgba16f, 2, 2)), decode_exr_cube);
    check(*encode_exr_table(sample_table(PixelFormat::rg32f)), decode_exr_table);
    check(*encode_exr_table(sample_table(PixelFormat::rgba16f, 4, 2)), decode_exr_table);
}

TEST(Exr, TheOtherKindIsUnusable) {
    const auto cube = decode_exr_cube(*encode_exr_table(sample_table(PixelFormat::rg16f)));
    ASSERT_FALSE(cube);
    EXPECT_EQ(cube.error().kind, ErrorKind::unusable_input);
}

}  // namespace
}  // namespace splitsum
