#include "splitsum/color/display.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "splitsum/base/atomic_file.h"

namespace splitsum {
namespace {

std::array<float, 3> shown(float r, float g, float b) {
    const auto display = DisplayTransform::sdr();
    EXPECT_TRUE(display) << display.error().message;
    std::array<float, 3> rgb = {r, g, b};
    display->apply(rgb);
    return rgb;
}

TEST(Display, RisesWithLightAndStaysInRange) {
    float before = -1;
    for (float light = 0.004f; light < 10; light *= 1.4f) {
        const auto rgb = shown(light, light, light);
        EXPECT_GT(rgb[0], before) << light;
        EXPECT_LE(rgb[0], 1);
        before = rgb[0];
    }
    EXPECT_NEAR(shown(0, 0, 0)[0], 0, 1e-6);
    EXPECT_EQ(shown(1e6f, 1e6f, 1e6f)[1], 1);
}

TEST(Display, KeepsGreysGrey) {
    for (const float light : {0.01f, 0.18f, 1.0f, 5.0f}) {
        const auto rgb = shown(light, light, light);
        EXPECT_NEAR(rgb[0], rgb[1], 2e-3);
        EXPECT_NEAR(rgb[1], rgb[2], 2e-3);
    }
}

// The reference rendering shows mid grey 0.18 at a tenth of the screen's white.
TEST(Display, ShowsMidGreyAtATenthOfWhite) {
    const double encoded = shown(0.18f, 0.18f, 0.18f)[0];
    EXPECT_NEAR(std::pow((encoded + 0.055) / 1.055, 2.4), 0.1, 0.005);
}

TEST(Display, TakesNothing) {
    const auto display = DisplayTransform::sdr();
    ASSERT_TRUE(display);
    display->apply({});
}

TEST(Display, KeepsChannelsInOrder) {
    const auto rgb = shown(0.8f, 0.2f, 0.05f);
    EXPECT_GT(rgb[0], rgb[1] + 0.1f);
    EXPECT_GT(rgb[1], rgb[2] + 0.1f);
}

class ConfigDisplay : public testing::Test {
protected:
    std::filesystem::path write(const std::string& roles) {
        const auto path = std::filesystem::path(testing::TempDir()) /
                          (std::string("display_") +
                           testing::UnitTest::GetInstance()->current_test_info()->name() + ".ocio");
        const auto status = write_text_whole(
            path, "ocio_profile_version: 2\nroles:\n  default: base\n" + roles +
                      "displays:\n"
                      "  a/b:\n    - !<View> {name: Plain, colorspace: base}\n"
                      "    - !<View> {name: Half, colorspace: half}\n"
                      "  c:\n    - !<View> {name: Raw, colorspace: base}\n"
                      "colorspaces:\n  - !<ColorSpace>\n    name: base\n"
                      "  - !<ColorSpace>\n    name: half\n    from_scene_reference: "
                      "!<MatrixTransform> {matrix: [0.5,0,0,0, 0,0.5,0,0, 0,0,0.5,0, 0,0,0,1]}\n");
        EXPECT_TRUE(status) << status.error().message;
        return path;
    }

    static void expect_shown(const std::filesystem::path& config, const std::string& view,
                             const std::array<float, 3>& expected) {
        const auto display = DisplayTransform::of_config(config, view);
        ASSERT_TRUE(display) << display.error().message;
        std::array<float, 3> rgb = {0.8f, 0.2f, 0.1f};
        display->apply(rgb);
        for (size_t c = 0; c < 3; ++c) EXPECT_NEAR(rgb[c], expected[c], 1e-5) << view << c;
    }
};

// SMPTE ST 2065-1 from Rec.709, whites matched by Bradford: 0.43963, 0.38299, 0.17738; ...
TEST_F(ConfigDisplay, TakesRec709ThroughAces) {
    const auto config = write("  aces_interchange: base\n");
    const double m[3][3] = {{0.4396327, 0.3829886, 0.1773787},
                            {0.0897763, 0.8134394, 0.0967842},
                            {0.0175412, 0.1115466, 0.8709122}};
    std::array<float, 3> aces{}, half{};
    for (size_t c = 0; c < 3; ++c) {
        aces[c] = float(m[c][0] * 0.8 + m[c][1] * 0.2 + m[c][2] * 0.1);
        half[c] = 0.5f * aces[c];
    }
    expect_shown(config, "a/b/Plain", aces);
    expect_shown(config, "a/b/Half", half);
}

TEST_F(ConfigDisplay, TakesRec709ForSceneLinearWithoutAces) {
    expect_shown(write("  scene_linear: base\n"), "a/b/Half", {0.4f, 0.1f, 0.05f});
}

TEST_F(ConfigDisplay, RefusesWhatCannotBeShown) {
    const auto good = write("  scene_linear: base\n");
    const auto without_display = DisplayTransform::of_config(good, "Plain");
    ASSERT_FALSE(without_display);
    EXPECT_EQ(without_display.error().kind, ErrorKind::bad_argument);
    EXPECT_NE(without_display.error().message.find("a/b/Plain, a/b/Half, c/Raw"), std::string::npos)
        << without_display.error().message;
    const auto without_role = DisplayTransform::of_config(write(""), "a/b/Plain");
    ASSERT_FALSE(without_role);
    EXPECT_NE(without_role.error().message.find("scene_linear"), std::string::npos);
    const auto absent = DisplayTransform::of_config("no/such.ocio", "a/b/Plain");
    ASSERT_FALSE(absent);
    EXPECT_EQ(absent.error().kind, ErrorKind::unreadable_input);
}

TEST_F(ConfigDisplay, ViewsAreListedInOrder) {
    const auto views = views_of_config(write("  scene_linear: base\n"));
    ASSERT_TRUE(views);
    EXPECT_EQ(*views, (std::vector<std::string>{"a/b/Plain", "a/b/Half", "c/Raw"}));
}

}  // namespace
}  // namespace splitsum
