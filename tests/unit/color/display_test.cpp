#include "splitsum/color/display.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

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

}  // namespace
}  // namespace splitsum
