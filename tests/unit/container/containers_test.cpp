#include "splitsum/container/containers.h"

#include <gtest/gtest.h>

#include "unit/container/sample_textures.h"

namespace splitsum {
namespace {

TEST(Containers, EachBringsBackWhatItWrote) {
    ASSERT_EQ(containers().size(), 3u);
    for (const Container& container : containers())
        for (const TextureAsset& texture :
             {sample_cube(PixelFormat::rgba16f), sample_table(PixelFormat::rg16f)}) {
            const auto path = std::filesystem::path(testing::TempDir()) /
                              ("any" + std::string(container.extension));
            ASSERT_TRUE(write_texture(texture, path, {.ktx2 = {.zstd = true}}));
            const auto back = read_texture(path);
            ASSERT_TRUE(back) << back.error().message;
            EXPECT_TRUE(same_texels(*back, texture)) << container.extension;
            for (const auto& [key, value] : texture.metadata)
                EXPECT_EQ(back->metadata.count(key), container.keeps_metadata ? 1u : 0u) << key;
        }
}

TEST(Containers, ExtensionsMatchInEitherCase) {
    EXPECT_EQ(container_of("Sky.KTX2")->extension, ".ktx2");
    EXPECT_EQ(container_of("a.b/sky.Exr")->extension, ".exr");
    EXPECT_EQ(container_of("SKY.DDS")->extension, ".dds");
}

TEST(Containers, AnUnknownExtensionIsToldWhatWorks) {
    for (const char* path : {"sky.png", "sky", "ktx2"}) {
        const Status status = write_texture(sample_table(PixelFormat::rg16f), path);
        ASSERT_FALSE(status) << path;
        EXPECT_EQ(status.error().kind, ErrorKind::bad_argument);
        EXPECT_NE(status.error().message.find(path), std::string::npos);
        EXPECT_NE(status.error().message.find(".ktx2, .exr, .dds"), std::string::npos);
        EXPECT_EQ(read_texture(path).error().kind, ErrorKind::bad_argument);
    }
}

TEST(Containers, AFullOrMissingDiskIsUnwritable) {
    for (const Container& container : containers()) {
        const auto path = "no/such/folder/x" + std::string(container.extension);
        const Status status = write_texture(sample_cube(PixelFormat::rgba16f), path);
        ASSERT_FALSE(status);
        EXPECT_EQ(status.error().kind, ErrorKind::unwritable_output);
    }
}

}  // namespace
}  // namespace splitsum
