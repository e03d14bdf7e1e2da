#include "splitsum/preview/difference.h"

#include <gtest/gtest.h>

namespace splitsum {
namespace {

using Color = std::array<uint8_t, 3>;

constexpr Color background = {30, 31, 34};

/// One row of pixels of these radiances; none where one is below 0.
TruthPicture row_of(const std::vector<float>& radiances) {
    TruthPicture truth;
    truth.width = int(radiances.size());
    truth.height = 1;
    for (const float radiance : radiances) {
        truth.sphere_at.push_back(radiance < 0 ? TruthPicture::background : 0);
        truth.mean.emplace_back(std::max(radiance, 0.0f));
    }
    return truth;
}

Image picture_of(const std::vector<float>& radiances) {
    Image picture(int(radiances.size()), 1);
    for (size_t i = 0; i < radiances.size(); ++i)
        for (size_t c = 0; c < 3; ++c) picture.rgb[3 * i + c] = radiances[i];
    return picture;
}

std::vector<Color> colors(const std::vector<float>& baked, const std::vector<float>& truth) {
    const auto bytes = difference_picture(picture_of(baked), row_of(truth));
    std::vector<Color> colors;
    for (size_t i = 0; i < bytes.size(); i += 3)
        colors.push_back({bytes[i], bytes[i + 1], bytes[i + 2]});
    return colors;
}

TEST(Difference, IsWhiteWhereThereIsNone) {
    for (const Color& color : colors({0.1f, 3, 700}, {0.1f, 3, 700}))
        EXPECT_EQ(color, (Color{255, 255, 255}));
}

TEST(Difference, IsRedWhereBakedLightIsBrighterAndBlueWhereItIsDarker) {
    const auto found = colors({1.1f, 0.9f}, {1, 1});
    EXPECT_GT(found[0][0], found[0][2]);
    EXPECT_LT(found[1][0], found[1][2]);
}

TEST(Difference, GrowsInEvenStepsUpToItsEnd) {
    for (const double sign : {-1.0, 1.0}) {
        const Color full = difference_color(sign * full_difference);
        for (double share = 0; share <= 1; share += 0.125)
            for (size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(difference_color(sign * share * full_difference)[c],
                            255 + share * (full[c] - 255), 0.51);
        EXPECT_EQ(difference_color(sign * 10), full);
    }
}

// Bright and dark pixels with the same ratio have one colour.
TEST(Difference, IsRelativeToTheTruth) {
    const auto found = colors({1.1f, 11, 0.11f}, {1, 10, 0.1f});
    EXPECT_EQ(found[0], found[1]);
    EXPECT_EQ(found[0], found[2]);
    EXPECT_NE(found[0], (Color{255, 255, 255}));
}

// 1e-4 beside a mean of 1: a thousandth of the least that counts.
TEST(Difference, OfDarknessIsMeasuredByTheRest) {
    const auto found = colors({0, 0.0021f, 2}, {0, 0.0001f, 2});
    EXPECT_EQ(found[0], (Color{255, 255, 255}));
    EXPECT_EQ(found[1], difference_color(0.002 / (0.01 * 2.0001 / 3)));
    const auto black = colors({0, 0}, {0, 0});
    EXPECT_EQ(black[0], (Color{255, 255, 255}));
}

TEST(Difference, LeavesTheBackgroundOut) {
    const auto found = colors({5, 1}, {-1, 1});
    EXPECT_EQ(found[0], background);
    EXPECT_EQ(found[1], (Color{255, 255, 255}));
}

}  // namespace
}  // namespace splitsum
