#include "splitsum/color/config_hash.h"

#include <gtest/gtest.h>

#include "support/temporary_folder.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

std::string config_with(const std::string& transform) {
    return "ocio_profile_version: 2\nsearch_path: luts\nroles:\n  default: base\n"
           "  scene_linear: base\ndisplays:\n  screen:\n"
           "    - !<View> {name: Raw, colorspace: base}\ncolorspaces:\n"
           "  - !<ColorSpace>\n    name: base\n"
           "  - !<ColorSpace>\n    name: film\n    to_scene_reference: " +
           transform + "\n";
}

std::string curve(const std::string& end) {
    return "Version 1\nFrom 0 1\nLength 2\nComponents 1\n{\n0\n" + end + "\n}\n";
}

const std::string in_a_group =
    "!<GroupTransform>\n      children:\n        - !<MatrixTransform> {offset: [1, 0, 0, 0]}\n"
    "        - !<FileTransform> {src: film.spi1d, interpolation: linear}";

class ConfigHash : public testing::Test {
protected:
    fs::path write(const std::string& name, const std::string& transform, const std::string& lut) {
        fs::create_directories(folder_ / name / "luts");
        tests::write_bytes(folder_ / name / "config.ocio", config_with(transform));
        if (!lut.empty()) tests::write_bytes(folder_ / name / "luts" / "film.spi1d", lut);
        return folder_ / name / "config.ocio";
    }
    std::string hash(const fs::path& config) {
        ConfigHashes hashes;
        const auto hash = hashes.of(config);
        EXPECT_TRUE(hash) << hash.error().message;
        return hash ? *hash : "";
    }

    tests::TemporaryFolder folder_;
};

TEST_F(ConfigHash, IsOfWhatTheFilesSayAndNotOfWhereTheyLie) {
    const auto one = hash(write("one", in_a_group, curve("0.5")));
    EXPECT_EQ(one, hash(write("same", in_a_group, curve("0.5"))));
    EXPECT_NE(one, hash(write("other", in_a_group, curve("0.6"))));
    EXPECT_NE(one, hash(write("without", in_a_group, "")));
    EXPECT_NE(one,
              hash(write("unused", "!<MatrixTransform> {offset: [1, 0, 0, 0]}", curve("0.5"))));
    EXPECT_TRUE(one.starts_with("xxh3-128:"));
}

TEST_F(ConfigHash, IsTakenOnce) {
    ConfigHashes hashes;
    const fs::path config = write("one", in_a_group, curve("0.5"));
    const auto before = hashes.of(config);
    write("one", in_a_group, curve("0.6"));
    EXPECT_EQ(*hashes.of(config), *before);
    EXPECT_NE(hash(config), *before);
}

TEST_F(ConfigHash, NeedsAConfig) {
    tests::write_bytes(folder_ / "broken.ocio", "colorspaces: [");
    for (const char* name : {"none.ocio", "broken.ocio"}) {
        ConfigHashes hashes;
        const auto hash = hashes.of(folder_ / name);
        ASSERT_FALSE(hash);
        EXPECT_EQ(hash.error().kind, ErrorKind::unreadable_input);
        EXPECT_NE(hash.error().message.find(name), std::string::npos);
    }
    EXPECT_EQ(hash(""), "built-in");
}

}  // namespace
}  // namespace splitsum
