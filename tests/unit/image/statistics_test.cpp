#include "splitsum/image/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "splitsum/base/parallel.h"

namespace splitsum {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

// Every pixel differs from every other in every channel.
Image lopsided(int width, int height) {
    Image image(width, height);
    for (size_t i = 0; i < image.rgb.size(); ++i)
        image.rgb[i] = 0.25f + 0.01f * static_cast<float>(i) + (i % 3 == 1 ? 5.0f : 0.0f);
    return image;
}

float& value(Image& image, int x, int y, int channel) {
    return image.row(y)[static_cast<size_t>(3 * x + channel)];
}

// The mean of one channel over a list of pixels.
float mean(Image& image, int channel, std::initializer_list<std::pair<int, int>> pixels) {
    double sum = 0;
    for (const auto& [x, y] : pixels) sum += value(image, x, y, channel);
    return static_cast<float>(sum / static_cast<double>(pixels.size()));
}

TEST(Census, CountsAPixelOnceForItsWorstChannel) {
    Image image = lopsided(16, 8);
    value(image, 7, 2, 0) = -1;
    value(image, 7, 2, 1) = nan;
    value(image, 7, 2, 2) = infinity;
    value(image, 3, 5, 2) = -infinity;
    value(image, 9, 5, 0) = infinity;
    value(image, 2, 6, 1) = -1e-30f;
    value(image, 4, 7, 1) = -0.0f;
    const Census census = take_census(image);
    EXPECT_EQ(census.nan.count, 1);
    EXPECT_EQ(census.infinite.count, 2);
    EXPECT_EQ(census.negative.count, 1);
    EXPECT_EQ(describe(census),
              "1 NaN (first at x 7, y 2), 2 infinite (first at x 3, y 5), "
              "1 negative (first at x 2, y 6)");
    EXPECT_FALSE(census.clean());
}

// The quick answer and the census must agree, wherever the value is.
TEST(Census, AgreesWithTheAnswerForARow) {
    constexpr float largest = std::numeric_limits<float>::max();
    constexpr float tiny = std::numeric_limits<float>::denorm_min();
    for (const float odd :
         {0.0f, -0.0f, tiny, -tiny, largest, -largest, infinity, -infinity, nan, -nan, 1.0f, -1.0f})
        for (int width = 1; width < 23; ++width)
            for (size_t at = 0; at < 3 * static_cast<size_t>(width); ++at) {
                Image image = lopsided(width, 1);
                image.rgb[at] = odd;
                const bool radiance = std::isfinite(odd) && !(odd < 0);
                ASSERT_EQ(all_are_radiance(image.rgb), radiance) << odd << " at " << at;
                ASSERT_EQ(take_census(image).clean(), radiance) << odd << " at " << at;
            }
    EXPECT_TRUE(all_are_radiance({}));
}

TEST(Census, FindsNothingInACleanImage) {
    const Census census = take_census(lopsided(6, 3));
    EXPECT_TRUE(census.clean());
    EXPECT_EQ(describe(census), "clean");
    EXPECT_EQ(describe(take_census(Image())), "clean");
}

TEST(Repair, LeavesGoodPixelsAlone) {
    Image image = lopsided(16, 8);
    const Image before = image;
    repair(image);
    EXPECT_EQ(image.rgb, before.rgb);
}

TEST(Repair, SetsOnlyNegativeChannelsToZero) {
    Image image = lopsided(16, 8);
    Image expected = image;
    value(image, 5, 1, 2) = -3;
    value(expected, 5, 1, 2) = 0;
    repair(image);
    EXPECT_EQ(image.rgb, expected.rgb);
}

TEST(Repair, TakesTheMeanOfTheNeighbours) {
    Image image = lopsided(16, 8);
    Image source = image;
    value(image, 5, 3, 1) = nan;
    repair(image);
    for (int c = 0; c < 3; ++c)
        EXPECT_FLOAT_EQ(
            value(image, 5, 3, c),
            mean(source, c, {{4, 2}, {5, 2}, {6, 2}, {4, 3}, {6, 3}, {4, 4}, {5, 4}, {6, 4}}));
}

TEST(Repair, WrapsAroundTheSeam) {
    Image image = lopsided(16, 8);
    Image source = image;
    value(image, 0, 3, 0) = infinity;
    repair(image);
    EXPECT_FLOAT_EQ(
        value(image, 0, 3, 0),
        mean(source, 0, {{15, 2}, {0, 2}, {1, 2}, {15, 3}, {1, 3}, {15, 4}, {0, 4}, {1, 4}}));
}

TEST(Repair, LooksAcrossThePoles) {
    Image image = lopsided(16, 8);
    Image source = image;
    value(image, 3, 0, 0) = nan;
    value(image, 12, 7, 2) = nan;
    repair(image);
    EXPECT_FLOAT_EQ(
        value(image, 3, 0, 0),
        mean(source, 0, {{10, 0}, {11, 0}, {12, 0}, {2, 0}, {4, 0}, {2, 1}, {3, 1}, {4, 1}}));
    EXPECT_FLOAT_EQ(
        value(image, 12, 7, 2),
        mean(source, 2, {{3, 7}, {4, 7}, {5, 7}, {11, 7}, {13, 7}, {11, 6}, {12, 6}, {13, 6}}));
}

// A fill in scan order would smear the left and upper rim over the hole.
TEST(Repair, DoesNotDependOnTheOrderOfThePixels) {
    const auto with_hole = [](Image image) {
        for (int y = 2; y < 7; ++y)
            for (int x = 4; x < 11; ++x) value(image, x, y, (x + y) % 3) = nan;
        return image;
    };
    const auto turned = [](Image image) {
        for (int y = 0; y < image.height / 2; ++y)
            std::swap_ranges(image.row(y).begin(), image.row(y).end(),
                             image.row(image.height - 1 - y).begin());
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width / 2; ++x)
                for (int c = 0; c < 3; ++c)
                    std::swap(value(image, x, y, c), value(image, image.width - 1 - x, y, c));
        return image;
    };
    Image straight = with_hole(lopsided(16, 9));
    Image upside_down = turned(straight);
    repair(straight);
    repair(upside_down);
    const Image back = turned(upside_down);
    for (size_t i = 0; i < straight.rgb.size(); ++i)
        EXPECT_NEAR(straight.rgb[i], back.rgb[i], 1e-5) << "value " << i;
}

TEST(Repair, StaysWithinTheValuesAroundAHole) {
    Image image = lopsided(32, 16);
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 32; ++x) value(image, x, y, 0) = nan;
    const Image source = image;
    repair(image);
    EXPECT_TRUE(take_census(image).clean());
    const auto rim = source.row(12);
    for (int x = 0; x < 32; ++x) EXPECT_LE(value(image, x, 0, 1), *std::ranges::max_element(rim));
}

TEST(Repair, MakesAnImageWithoutGoodPixelsBlack) {
    for (const auto& [width, height] : {std::pair{2, 1}, {1, 1}, {5, 3}}) {
        Image image(width, height);
        std::ranges::fill(image.rgb, nan);
        repair(image);
        EXPECT_EQ(image.rgb, Image(width, height).rgb);
    }
}

TEST(Repair, ReachesEveryPixelFromOneGoodPixel) {
    Image image(9, 5);
    std::ranges::fill(image.rgb, infinity);
    for (int c = 0; c < 3; ++c) value(image, 8, 4, c) = 2;
    repair(image);
    for (const float v : image.rgb) EXPECT_EQ(v, 2);
}

TEST(Repair, GivesTheSameBitsForAnyNumberOfThreads) {
    const auto repaired = [](int threads) {
        const ThreadLimit limit(threads);
        Image image = lopsided(128, 64);
        for (size_t i = 0; i < image.rgb.size(); i += i % 11 + 1) image.rgb[i] = nan;
        repair(image);
        return image.rgb;
    };
    EXPECT_EQ(repaired(1), repaired(4));
}

}  // namespace
}  // namespace splitsum
