#include "splitsum/container/ktx2.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <string>

#include "splitsum/base/parallel.h"
#include "splitsum/base/random.h"
#include "unit/container/sample_textures.h"

namespace splitsum {
namespace {

using Bytes = std::vector<std::byte>;

constexpr Ktx2Options plain{};
constexpr Ktx2Options zstd{.zstd = true};

// Offsets of the specification, written here a second time on purpose.
constexpr size_t vk_format_at = 12, type_size_at = 16, width_at = 20, height_at = 24, depth_at = 28,
                 layers_at = 32, faces_at = 36, levels_at = 40, scheme_at = 44, dfd_at = 48,
                 kvd_at = 56, sgd_at = 64, index_at = 80;

uint32_t word(const Bytes& file, size_t offset) {
    uint32_t value;
    std::memcpy(&value, file.data() + offset, sizeof value);
    return value;
}

uint64_t long_word(const Bytes& file, size_t offset) {
    uint64_t value;
    std::memcpy(&value, file.data() + offset, sizeof value);
    return value;
}

void set(Bytes& file, size_t offset, uint32_t value) {
    std::memcpy(file.data() + offset, &value, sizeof value);
}

void set_long(Bytes& file, size_t offset, uint64_t value) {
    std::memcpy(file.data() + offset, &value, sizeof value);
}

Bytes encoded(const TextureAsset& texture, const Ktx2Options& options = plain) {
    auto file = encode_ktx2(texture, options);
    EXPECT_TRUE(file) << file.error().message;
    return *file;
}

TextureAsset sample(const PixelFormatInfo& info) {
    return holds_colours(info) ? sample_cube(info.format) : sample_table(info.format);
}

// The kind of error that a file of `kind` bytes with that change gives, or 0 for success.
template <class Change>
std::string outcome(Bytes file, const Change& change) {
    change(file);
    const auto texture = decode_ktx2(file);
    if (texture) return "read";
    return texture.error().kind == ErrorKind::unreadable_input ? "unreadable"
           : texture.error().kind == ErrorKind::unusable_input ? "unusable"
                                                               : "another error";
}

TEST(Ktx2, EveryFormatComesBack) {
    for (const PixelFormatInfo& info : pixel_formats())
        for (const Ktx2Options& options : {plain, zstd}) {
            const TextureAsset texture = sample(info);
            const auto back = decode_ktx2(encoded(texture, options));
            ASSERT_TRUE(back) << info.name << ": " << back.error().message;
            EXPECT_TRUE(same_texels(*back, texture)) << info.name;
            for (const auto& [key, value] : texture.metadata)
                EXPECT_EQ(back->metadata.at(key), value) << key;
            EXPECT_EQ(back->metadata.size(), texture.metadata.size() + 2);
            EXPECT_EQ(back->metadata.at("KTXorientation"), "rd");
        }
}

TEST(Ktx2, HeaderSaysWhatTheTextureIs) {
    const uint32_t type_sizes[] = {2, 4, 4, 4, 2, 4, 2};
    for (const PixelFormatInfo& info : pixel_formats()) {
        const TextureAsset texture = sample(info);
        const Bytes file = encoded(texture);
        EXPECT_EQ(std::memcmp(file.data(), "\xabKTX 20\xbb\r\n\x1a\n", 12), 0);
        EXPECT_EQ(word(file, vk_format_at), info.vk_format);
        EXPECT_EQ(word(file, type_size_at), type_sizes[static_cast<int>(info.format)]);
        EXPECT_EQ(word(file, width_at), static_cast<uint32_t>(texture.width));
        EXPECT_EQ(word(file, height_at), static_cast<uint32_t>(texture.height));
        EXPECT_EQ(word(file, depth_at), 0u);
        EXPECT_EQ(word(file, layers_at), 0u);
        EXPECT_EQ(word(file, faces_at), static_cast<uint32_t>(texture.face_count));
        EXPECT_EQ(word(file, levels_at), texture.levels.size());
        EXPECT_EQ(word(file, scheme_at), 0u);
        EXPECT_EQ(word(encoded(texture, zstd), scheme_at), 2u);
        EXPECT_EQ(long_word(file, sgd_at), 0u);
        EXPECT_EQ(long_word(file, sgd_at + 8), 0u);
    }
}

// Smallest level first, aligned to the least common multiple of texel and word, nothing behind the
// largest.
TEST(Ktx2, LevelsLieSmallestFirstAndAligned) {
    for (const PixelFormatInfo& info : pixel_formats()) {
        const TextureAsset texture = sample(info);
        const Bytes file = encoded(texture);
        const size_t alignment = std::max(4, info.bytes_per_texel);
        uint64_t previous = file.size();
        for (size_t level = 0; level < texture.levels.size(); ++level) {
            const uint64_t offset = long_word(file, index_at + 24 * level);
            const uint64_t length = long_word(file, index_at + 24 * level + 8);
            EXPECT_EQ(length, texture.levels[level].size());
            EXPECT_EQ(long_word(file, index_at + 24 * level + 16), length);
            EXPECT_EQ(offset % alignment, 0u) << info.name;
            EXPECT_LE(offset + length, previous) << "level " << level;
            EXPECT_LT(previous - (offset + length), alignment) << "level " << level;
            previous = offset;
        }
        EXPECT_EQ(word(file, dfd_at), index_at + 24 * texture.levels.size());
    }
}

TEST(Ktx2, KeysAreSortedTerminatedAndPadded) {
    TextureAsset texture = sample_table(PixelFormat::rg16f);
    texture.metadata = {{"b", "two"}, {"a", "1"}};
    const Bytes file = encoded(texture);
    const std::string data(reinterpret_cast<const char*>(file.data()) + word(file, kvd_at),
                           word(file, kvd_at + 4));
    const std::string orientation("\x12\0\0\0KTXorientation\0rd\0\0\0", 24);
    EXPECT_EQ(data.substr(0, 24), orientation);
    const std::string ours("\x04\0\0\0a\0\x31\0\x06\0\0\0b\0two\0\0\0", 20);
    EXPECT_EQ(data.substr(data.size() - 20), ours);
    EXPECT_EQ(data.find("KTXwriter"), 24u + 4);
    EXPECT_EQ(data.size() % 4, 0u);
}

// The descriptors of the Khronos Data Format Specification for these layouts, word by word.
TEST(Ktx2, DescriptorsDescribeTheBits) {
    const auto descriptor = [](const Bytes& file) {
        std::vector<uint32_t> words;
        for (size_t i = 0; i < word(file, dfd_at + 4); i += 4)
            words.push_back(word(file, word(file, dfd_at) + i));
        return words;
    };
    const uint32_t one = 0x3f800000, minus_one = 0xbf800000;
    EXPECT_EQ(descriptor(encoded(sample_table(PixelFormat::rg16f))),
              (std::vector<uint32_t>{60, 0, 2 | 56u << 16, 0x00010101, 0, 4, 0,  //
                                     0xc00f0000, 0, minus_one, one,              //
                                     0xc10f0010, 0, minus_one, one}));
    EXPECT_EQ(descriptor(encoded(sample_table(PixelFormat::rg32f), zstd)),
              (std::vector<uint32_t>{60, 0, 2 | 56u << 16, 0x00010101, 0, 0, 0,  //
                                     0xc01f0000, 0, minus_one, one,              //
                                     0xc11f0020, 0, minus_one, one}));
    EXPECT_EQ(descriptor(encoded(sample_cube(PixelFormat::b10g11r11))),
              (std::vector<uint32_t>{76, 0, 2 | 72u << 16, 0x00010101, 0, 4, 0,  //
                                     0x800a0000, 0, 0, one,                      //
                                     0x810a000b, 0, 0, one,                      //
                                     0x82090016, 0, 0, one}));
    EXPECT_EQ(descriptor(encoded(sample_cube(PixelFormat::rgb9e5))),
              (std::vector<uint32_t>{124,        0,          2 | 120u << 16,
                                     0x00010101, 0,          4,
                                     0,  //
                                     0x00080000, 0,          0,
                                     8448,       0x2004001b, 0,
                                     15,         31,  //
                                     0x01080009, 0,          0,
                                     8448,       0x2104001b, 0,
                                     15,         31,  //
                                     0x02080012, 0,          0,
                                     8448,       0x2204001b, 0,
                                     15,         31}));
    const auto rgba = descriptor(encoded(sample_cube(PixelFormat::rgba16f)));
    ASSERT_EQ(rgba.size(), 23u);
    EXPECT_EQ(rgba[19], 0xcf0f0030);  // alpha is channel 15
}

TEST(Ktx2, EqualTexturesGiveEqualBytesOnAnyNumberOfThreads) {
    const TextureAsset texture = sample_cube(PixelFormat::rgba16f, 64, 7);
    const auto run = [&](int threads) {
        const ThreadLimit limit(threads);
        return encoded(texture, zstd);
    };
    EXPECT_EQ(run(1), run(8));
}

TEST(Ktx2, ReadsFilesWithoutKeysAndWithoutLevelCount) {
    const TextureAsset texture = sample_cube(PixelFormat::rgba16f, 4, 1);
    Bytes file = encoded(texture);
    set(file, kvd_at, 0);
    set(file, kvd_at + 4, 0);
    set(file, levels_at, 0);  // "make the levels yourself": there is one in the file
    const auto back = decode_ktx2(file);
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_TRUE(same_texels(*back, texture));
    EXPECT_TRUE(back->metadata.empty());
}

TEST(Ktx2, EveryPrefixIsUnreadable) {
    for (const Ktx2Options& options : {plain, zstd}) {
        const Bytes file = encoded(sample_cube(PixelFormat::rgb9e5, 4, 3), options);
        for (size_t length = 0; length < file.size(); ++length) {
            const auto texture = decode_ktx2(std::span(file).first(length));
            ASSERT_FALSE(texture) << length << " of " << file.size();
            ASSERT_EQ(texture.error().kind, ErrorKind::unreadable_input) << length;
        }
    }
}

// No byte may lead the reader out of the file: with the address sanitizer this is a proof of sorts.
TEST(Ktx2, AnyChangedByteIsReadOrRefused) {
    for (const Ktx2Options& options : {plain, zstd}) {
        const Bytes good = encoded(sample_cube(PixelFormat::b10g11r11, 2, 2), options);
        for (size_t i = 0; i < good.size(); ++i)
            for (const int change : {1, 0x80, 0xff}) {
                Bytes file = good;
                file[i] ^= static_cast<std::byte>(change);
                const auto texture = decode_ktx2(file);
                if (texture) {
                    EXPECT_TRUE(validate(*texture)) << i;
                }
            }
    }
}

TEST(Ktx2, RefusesWhatContradictsItself) {
    const Bytes good = encoded(sample_cube(PixelFormat::rgba16f));
    const auto after = [&](size_t offset, uint32_t value) {
        return outcome(good, [&](Bytes& file) { set(file, offset, value); });
    };
    const auto after_long = [&](size_t offset, uint64_t value) {
        return outcome(good, [&](Bytes& file) { set_long(file, offset, value); });
    };
    ASSERT_EQ(outcome(good, [](Bytes&) {}), "read");
    EXPECT_EQ(after(0, 0x12345678), "unreadable");
    EXPECT_EQ(after(width_at, 0), "unreadable");
    EXPECT_EQ(after(width_at, 16), "unreadable");
    EXPECT_EQ(outcome(good,
                      [](Bytes& file) {
                          set(file, width_at, 0xffffffff);
                          set(file, height_at, 0xffffffff);
                      }),
              "unreadable");
    EXPECT_EQ(after(faces_at, 7), "unreadable");
    EXPECT_EQ(after(levels_at, 5), "unreadable");
    EXPECT_EQ(after(levels_at, 0xffffffff), "unreadable");
    EXPECT_EQ(after(dfd_at, 0xfffffff0), "unreadable");
    EXPECT_EQ(after(dfd_at + 4, 0), "unreadable");
    EXPECT_EQ(after(kvd_at + 4, 0xfffffff0), "unreadable");
    EXPECT_EQ(after(word(good, kvd_at), 0xffffff), "unreadable") << "the first entry's length";
    EXPECT_EQ(after_long(index_at, ~uint64_t{0} - 100), "unreadable") << "offset + length wraps";
    EXPECT_EQ(after_long(index_at, good.size() - 1), "unreadable");
    EXPECT_EQ(after_long(index_at, 0), "unreadable") << "level 0 over the header";
    EXPECT_EQ(after_long(index_at + 24, long_word(good, index_at)), "unreadable") << "overlap";
    EXPECT_EQ(after_long(index_at + 8, 8), "unreadable") << "a level that is too short";
}

TEST(Ktx2, KeepsTheLayersOfAnArray) {
    for (const PixelFormatInfo& info : pixel_formats()) {
        if (!holds_tables(info)) continue;
        const TextureAsset texture = sample_table(info.format, info.channels, 3);
        for (const Ktx2Options& options : {plain, zstd}) {
            const Bytes file = encoded(texture, options);
            EXPECT_EQ(word(file, layers_at), 3u);
            EXPECT_EQ(word(file, faces_at), 1u);
            const auto back = decode_ktx2(file);
            ASSERT_TRUE(back) << back.error().message;
            EXPECT_TRUE(same_texels(*back, texture)) << info.name;
            EXPECT_EQ(outcome(file, [&](Bytes& f) { set(f, layers_at, 4); }), "unreadable");
            EXPECT_EQ(outcome(file, [&](Bytes& f) { set(f, layers_at, 0xffffffff); }),
                      "unreadable");
        }
    }
}

TEST(Ktx2, RefusesOtherKindsOfTexture) {
    const Bytes good = encoded(sample_cube(PixelFormat::rgba16f));
    const auto after = [&](size_t offset, uint32_t value) {
        return outcome(good, [&](Bytes& file) { set(file, offset, value); });
    };
    EXPECT_EQ(after(vk_format_at, 131), "unusable") << "BC6H";
    EXPECT_EQ(after(vk_format_at, 0), "unusable") << "Basis";
    EXPECT_EQ(after(height_at, 0), "unusable") << "1D";
    EXPECT_EQ(after(depth_at, 4), "unusable") << "3D";
    EXPECT_EQ(after(layers_at, 2), "unusable") << "array of cubemaps";
    EXPECT_EQ(after(scheme_at, 3), "unusable") << "zlib";
    EXPECT_EQ(outcome(good,
                      [&](Bytes& file) {  // "rd" of KTXorientation
                          file[word(file, kvd_at) + 4 + 15 + 1] = std::byte{'u'};
                      }),
              "unusable")
        << "rows bottom up";
}

// Frames that hold more than the texture, whether they admit it or not, and sizes that no frame of
// that length can hold.
TEST(Ktx2, RefusesZstandardBombs) {
    const Bytes small = encoded(sample_cube(PixelFormat::rgba16f, 4, 1), zstd);
    const Bytes large = encoded(sample_cube(PixelFormat::rgba16f, 512, 1), zstd);
    const auto stored = std::span(large).subspan(long_word(large, index_at));
    Bytes bomb(small.begin(), small.begin() + static_cast<long>(long_word(small, index_at)));
    bomb.insert(bomb.end(), stored.begin(), stored.end());
    set_long(bomb, index_at + 8, stored.size());
    EXPECT_EQ(outcome(bomb, [](Bytes&) {}), "unreadable");

    EXPECT_EQ(outcome(small,
                      [](Bytes& file) {
                          set(file, width_at, 8192);
                          set(file, height_at, 8192);
                          set_long(file, index_at + 16, uint64_t{8192} * 8192 * 6 * 8);
                      }),
              "unreadable");
    EXPECT_EQ(outcome(small,
                      [](Bytes& file) {
                          set(file, width_at, 32768);
                          set(file, height_at, 32768);
                          set_long(file, index_at + 16, uint64_t{32768} * 32768 * 6 * 8);
                      }),
              "unusable")
        << "51 GB of texels";
}

TEST(Ktx2, RefusesWhatItCannotStore) {
    TextureAsset texture = sample_table(PixelFormat::rg16f);
    const auto kind = [&](const Ktx2Options& options = plain) {
        const auto file = encode_ktx2(texture, options);
        return file ? ErrorKind::internal : file.error().kind;
    };
    EXPECT_EQ(kind({.zstd = true, .zstd_level = 0}), ErrorKind::bad_argument);
    EXPECT_EQ(kind({.zstd = true, .zstd_level = 23}), ErrorKind::bad_argument);
    texture.metadata = {{"", "no key"}};
    EXPECT_EQ(kind(), ErrorKind::bad_argument);
    texture.metadata.clear();
    texture.levels[0].pop_back();
    EXPECT_EQ(kind(), ErrorKind::bad_argument);
}

TEST(Ktx2, FilesComeBackAndErrorsNameThem) {
    const auto path = std::filesystem::path(testing::TempDir()) / "sample.ktx2";
    const TextureAsset texture = sample_cube(PixelFormat::rgba32f);
    ASSERT_TRUE(write_ktx2(texture, path, zstd));
    const auto back = read_ktx2(path);
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_TRUE(same_texels(*back, texture));

    std::filesystem::resize_file(path, 100);
    for (const auto& unreadable : {path, path.parent_path() / "missing.ktx2", path.parent_path()}) {
        const auto texture_or = read_ktx2(unreadable);
        ASSERT_FALSE(texture_or);
        EXPECT_EQ(texture_or.error().kind, ErrorKind::unreadable_input);
        EXPECT_NE(texture_or.error().message.find(unreadable.string()), std::string::npos);
    }
    const Status written = write_ktx2(texture, "no/such/folder/x.ktx2");
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().kind, ErrorKind::unwritable_output);
}

}  // namespace
}  // namespace splitsum
