#include "splitsum/color/color_space.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "splitsum/base/atomic_file.h"
#include "splitsum/base/parallel.h"

namespace splitsum {
namespace {

using Triple = std::array<float, 3>;

ColorConfig builtin() {
    auto config = ColorConfig::load({});
    EXPECT_TRUE(config) << config.error().message;
    return std::move(*config);
}

Triple convert(const ColorConverter& converter, const Triple& rgb) {
    Image image(1, 1);
    std::copy(rgb.begin(), rgb.end(), image.rgb.begin());
    converter.apply(image);
    return {image.rgb[0], image.rgb[1], image.rgb[2]};
}

Triple from(const std::string& space, const Triple& rgb) {
    const auto converter = builtin().converter_from(space);
    EXPECT_TRUE(converter) << converter.error().message;
    return convert(*converter, rgb);
}

void expect_near(const Triple& found, const Triple& wanted, float tolerance) {
    for (size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c], wanted[c], tolerance) << "channel " << c;
}

TEST(Primaries, WhiteStaysWhite) {
    for (const Primaries& p : {rec709_primaries, rec2020_primaries, p3_d65_primaries,
                               aces_ap0_primaries, aces_ap1_primaries}) {
        const ColorMatrix m = rgb_from_rgb(rec709_primaries, p);
        for (size_t i = 0; i < 3; ++i)
            EXPECT_NEAR(m[3 * i] + m[3 * i + 1] + m[3 * i + 2], 1, 1e-12);
    }
}

// ITU-R BT.709-6, 3.2: the luminance weights, printed there to four digits.
TEST(Primaries, GiveThePublishedLuminanceWeights) {
    const ColorMatrix m = xyz_from_rgb(rec709_primaries);
    EXPECT_NEAR(m[3], 0.2126, 5e-5);
    EXPECT_NEAR(m[4], 0.7152, 5e-5);
    EXPECT_NEAR(m[5], 0.0722, 5e-5);
}

TEST(Primaries, RefusesThoseThatSpanNoColours) {
    EXPECT_TRUE(are_usable(aces_ap0_primaries));
    EXPECT_FALSE(are_usable({}));
    EXPECT_FALSE(are_usable({0.64, 0.33, 0.64, 0.33, 0.15, 0.06, 0.3127, 0.3290}));
    EXPECT_FALSE(are_usable({0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.8, 0.1}));
    EXPECT_FALSE(are_usable({std::nan(""), 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290}));
    EXPECT_FALSE(ColorConfig::converter_from_primaries({}));
}

TEST(ColorConfig, KnowsItsSpacesByNameAndAlias) {
    const ColorConfig config = builtin();
    EXPECT_EQ(config.default_space(), working_space);
    EXPECT_EQ(config.find("Linear"), working_space);
    EXPECT_EQ(config.find("scene_linear"), working_space);
    EXPECT_EQ(config.find("srgb"), "sRGB");
    EXPECT_EQ(config.find("acescg"), "ACEScg");
    EXPECT_EQ(config.find("Gamma2.2"), "g22_rec709");
    EXPECT_EQ(config.find("nonsense"), std::nullopt);
    EXPECT_EQ(config.find(""), std::nullopt);
    EXPECT_EQ(config.note(), "");
}

TEST(ColorConfig, EveryBuiltInSpaceKeepsWhiteAndBlack) {
    for (const std::string& space : builtin().spaces()) {
        SCOPED_TRACE(space);
        expect_near(from(space, {0, 0, 0}), {0, 0, 0}, 1e-7f);
        if (space != "XYZ-D65") expect_near(from(space, {1, 1, 1}), {1, 1, 1}, 2e-6f);
    }
    expect_near(from("XYZ-D65", {0.95046f, 1, 1.08906f}), {1, 1, 1}, 1e-4f);
}

// The columns that colour-science and OpenColorIO's own built-in transforms agree on.
TEST(ColorConfig, KnownPrimariesLandWhereTheyShould) {
    expect_near(from("ACEScg", {1, 0, 0}), {1.70505f, -0.13026f, -0.02400f}, 2e-5f);
    expect_near(from("ACES2065-1", {1, 0, 0}), {2.52169f, -0.27648f, -0.01538f}, 2e-5f);
    expect_near(from("lin_rec2020", {0, 1, 0}), {-0.58764f, 1.13290f, -0.10058f}, 2e-5f);
    expect_near(from("lin_p3d65", {0, 0, 1}), {0, 0, 1.09827f}, 2e-5f);
}

TEST(ColorConfig, TheWorkingSpaceChangesNoBit) {
    const auto converter = builtin().converter_from(working_space);
    ASSERT_TRUE(converter);
    EXPECT_TRUE(converter->changes_nothing());
    const Triple odd = {1e-38f, 65504.123f, -0.0f};
    EXPECT_EQ(convert(*converter, odd), odd);
    EXPECT_FALSE(builtin().converter_from("ACEScg")->changes_nothing());
}

// IEC 61966-2-1 and ITU-R BT.709-6 in fp64.
TEST(ColorConfig, DecodesTheCurvesToSixDigits) {
    for (float encoded = 0; encoded <= 1; encoded += 1.0f / 64) {
        const double e = encoded;
        const double srgb = e <= 0.04045 ? e / 12.92 : std::pow((e + 0.055) / 1.055, 2.4);
        const double camera = e < 0.081 ? e / 4.5 : std::pow((e + 0.099) / 1.099, 1 / 0.45);
        EXPECT_NEAR(from("sRGB", {encoded, 0, 0})[0], srgb, 2e-6) << e;
        EXPECT_NEAR(from("Rec709", {0, encoded, 0})[1], camera, 2e-4) << e;
        EXPECT_NEAR(from("g22_rec709", {0, 0, encoded})[2], std::pow(e, 2.2), 1e-6) << e;
    }
}

TEST(ColorConfig, ListsTheSpacesWhenANameIsUnknown) {
    const auto converter = builtin().converter_from("acesgc");
    ASSERT_FALSE(converter);
    EXPECT_EQ(converter.error().kind, ErrorKind::bad_argument);
    EXPECT_NE(converter.error().message.find("acesgc"), std::string::npos);
    EXPECT_NE(converter.error().message.find("ACEScg"), std::string::npos);
}

TEST(ColorConfig, ChromaticitiesAreRecognised) {
    EXPECT_EQ(space_with_primaries(aces_ap1_primaries), "ACEScg");
    Primaries nearly = rec2020_primaries;
    nearly[3] += 0.9e-3;
    EXPECT_EQ(space_with_primaries(nearly), "lin_rec2020");
    nearly[3] += 0.2e-3;
    EXPECT_EQ(space_with_primaries(nearly), std::nullopt);
}

TEST(ColorConfig, PrimariesAndTheNamedSpaceAgree) {
    const auto converter = ColorConfig::converter_from_primaries(aces_ap0_primaries);
    ASSERT_TRUE(converter);
    expect_near(convert(*converter, {0.2f, 0.5f, 3}), from("ACES2065-1", {0.2f, 0.5f, 3}), 1e-6f);
}

TEST(ColorConfig, GivesTheSameBitsForAnyNumberOfThreads) {
    const auto converter = builtin().converter_from("ACEScg");
    const auto converted = [&](int threads) {
        const ThreadLimit limit(threads);
        Image image(37, 19);
        for (size_t i = 0; i < image.rgb.size(); ++i) image.rgb[i] = 0.01f * float(i % 501);
        converter->apply(image);
        return image.rgb;
    };
    EXPECT_EQ(converted(1), converted(4));
}

class ConfigFile : public testing::Test {
protected:
    std::filesystem::path write(const std::string& roles, const std::string& spaces) {
        const auto path = std::filesystem::path(testing::TempDir()) /
                          (std::string("config_") +
                           testing::UnitTest::GetInstance()->current_test_info()->name() + ".ocio");
        const auto status = write_text_whole(
            path, "ocio_profile_version: 2\nroles:\n  default: base\n" + roles +
                      "displays:\n  screen:\n    - !<View> {name: Raw, colorspace: base}\n"
                      "colorspaces:\n" +
                      spaces);
        EXPECT_TRUE(status) << status.error().message;
        return path;
    }

    const std::string base = "  - !<ColorSpace>\n    name: base\n";
    const std::string twice =
        "  - !<ColorSpace>\n    name: twice\n    to_scene_reference: !<MatrixTransform> "
        "{matrix: [2,0,0,0, 0,2,0,0, 0,0,2,0, 0,0,0,1]}\n";
};

TEST_F(ConfigFile, WithoutInterchangeItsSceneLinearIsTheWorkingSpace) {
    const auto config = ColorConfig::load(write("  scene_linear: base\n", base + twice));
    ASSERT_TRUE(config) << config.error().message;
    EXPECT_NE(config->note().find("aces_interchange"), std::string::npos);
    const auto converter = config->converter_from("twice");
    ASSERT_TRUE(converter) << converter.error().message;
    expect_near(convert(*converter, {1, 2, 3}), {2, 4, 6}, 1e-6f);
}

TEST_F(ConfigFile, WithInterchangeItIsJoinedToRec709) {
    const auto config =
        ColorConfig::load(write("  scene_linear: twice\n  aces_interchange: base\n", base + twice));
    ASSERT_TRUE(config) << config.error().message;
    EXPECT_EQ(config->note(), "");
    EXPECT_EQ(config->default_space(), "twice");
    const auto converter = config->converter_from("twice");
    ASSERT_TRUE(converter) << converter.error().message;
    expect_near(convert(*converter, {0.5f, 0, 0}), {2.52169f, -0.27648f, -0.01538f}, 2e-5f);
}

TEST_F(ConfigFile, WithoutAnyLinearSpaceIsRefused) {
    const auto config = ColorConfig::load(write("", base));
    ASSERT_FALSE(config);
    EXPECT_EQ(config.error().kind, ErrorKind::bad_argument);
    EXPECT_NE(config.error().message.find("scene_linear"), std::string::npos);
}

TEST_F(ConfigFile, ThatIsAbsentOrBrokenIsNamed) {
    for (const auto& path : {std::filesystem::path("no/such.ocio"), write("  - [", base)}) {
        const auto config = ColorConfig::load(path);
        ASSERT_FALSE(config);
        EXPECT_EQ(config.error().kind, ErrorKind::unreadable_input);
        EXPECT_NE(config.error().message.find(path.string()), std::string::npos);
    }
}

}  // namespace
}  // namespace splitsum
