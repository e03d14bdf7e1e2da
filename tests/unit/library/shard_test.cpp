#include "splitsum/library/shard.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace splitsum {
namespace {

std::vector<int64_t> lopsided_library(int count) {
    std::mt19937 random(7);
    std::vector<int64_t> pixels;
    for (int i = 0; i < count; ++i)
        pixels.push_back(int64_t{1} << (10 + random() % 18));  // a few hold most of all pixels
    return pixels;
}

int64_t sum_of(const std::vector<int64_t>& pixels, const std::vector<size_t>& items) {
    return std::accumulate(items.begin(), items.end(), int64_t{0},
                           [&](int64_t sum, size_t item) { return sum + pixels[item]; });
}

TEST(Shard, EveryItemIsInExactlyOne) {
    for (const int items : {0, 1, 3, 100})
        for (const int count : {1, 2, 7, 150}) {
            const auto pixels = lopsided_library(items);
            std::vector<size_t> all;
            for (int index = 1; index <= count; ++index) {
                const auto mine = items_of({index, count}, pixels);
                EXPECT_TRUE(std::ranges::is_sorted(mine));
                all.insert(all.end(), mine.begin(), mine.end());
            }
            std::ranges::sort(all);
            std::vector<size_t> expected(static_cast<size_t>(items));
            std::iota(expected.begin(), expected.end(), size_t{0});
            EXPECT_EQ(all, expected) << items << " in " << count;
        }
}

// Graham's bound holds against the best split, which is at least the mean and the largest item.
TEST(Shard, IsBalancedByPixels) {
    const auto pixels = lopsided_library(200);
    const int64_t total = std::accumulate(pixels.begin(), pixels.end(), int64_t{0});
    for (const int count : {2, 5, 8}) {
        const double best = std::max(double(total) / count, double(std::ranges::max(pixels)));
        for (int index = 1; index <= count; ++index)
            EXPECT_LE(double(sum_of(pixels, items_of({index, count}, pixels))), best * 4 / 3)
                << index << "/" << count;
    }
}

TEST(Shard, SpreadsFilesThatCannotBeRead) {
    const std::vector<int64_t> pixels(30, 0);
    for (int index = 1; index <= 3; ++index) EXPECT_EQ(items_of({index, 3}, pixels).size(), 10u);
}

TEST(Shard, EqualItemsGoInTheOrderOfTheList) {
    EXPECT_EQ(items_of({1, 2}, std::vector<int64_t>{5, 5, 5, 5}), (std::vector<size_t>{0, 2}));
    EXPECT_EQ(items_of({2, 2}, std::vector<int64_t>{5, 5, 5, 5}), (std::vector<size_t>{1, 3}));
    EXPECT_EQ(items_of({1, 2}, std::vector<int64_t>{1, 2, 9, 3}), (std::vector<size_t>{2}));
}

TEST(Shard, IsReadFromText) {
    const auto shard = parse_shard("3/16");
    ASSERT_TRUE(shard) << shard.error().message;
    EXPECT_EQ(shard->index, 3);
    EXPECT_EQ(shard->count, 16);
    for (const char* text : {"", "/", "3", "3/", "/3", "0/3", "4/3", "-1/3", "1/0", "1/2/3", "1 /2",
                             "1/2x", "one/two", "99999999999/99999999999"})
        EXPECT_FALSE(parse_shard(text)) << text;
}

TEST(Shard, CountsThePixelsOfAHeader) {
    const std::filesystem::path data = SPLITSUM_TEST_DATA;
    EXPECT_EQ(pixels_in(data / "panoramas/sunset.exr", {}) % 2, 0);
    EXPECT_GT(pixels_in(data / "panoramas/sunset.exr", {}), 1000);
    EXPECT_EQ(pixels_in(data / "malformed/text.exr", {}), 0);
    EXPECT_EQ(pixels_in(data / "none.exr", {}), 0);
}

}  // namespace
}  // namespace splitsum
