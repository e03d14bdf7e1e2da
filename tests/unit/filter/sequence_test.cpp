#include "splitsum/filter/sequence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

#include "splitsum/math/low_discrepancy.h"

namespace splitsum {
namespace {

constexpr int cells = 16;  // along a side of the unit square

std::vector<int> counts_in_cells(const PointList& points, uint32_t count) {
    std::vector<int> counts(cells * cells, 0);
    for (uint32_t i = 0; i < count; ++i) {
        const Vec2d p = points[i];
        EXPECT_TRUE(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1) << p.x << ", " << p.y;
        ++counts[size_t(int(p.y * cells) * cells + int(p.x * cells))];
    }
    return counts;
}

double chi_square(const std::vector<int>& counts, double expected) {
    double sum = 0;
    for (const int count : counts) sum += (count - expected) * (count - expected) / expected;
    return sum;
}

// 255 degrees of freedom: 99.99 % of right samplers lie between 178 and 348.
void expect_random(const std::vector<int>& counts, double expected) {
    EXPECT_GT(chi_square(counts, expected), 178);
    EXPECT_LT(chi_square(counts, expected), 348);
}

TEST(PointList, RandomPointsFillTheSquareAtRandom) {
    constexpr uint32_t count = 100'000;
    expect_random(counts_in_cells(PointList::random({1, 2, 3}), count), count / 256.0);
    // Evenly spread ones are too even for that: the test can fail.
    EXPECT_LT(chi_square(counts_in_cells(PointList::hammersley(count), count), count / 256.0), 1);
}

// The same index over neighbouring directions, seeds and streams must be as random.
TEST(PointList, NeighbouringKeysAreIndependent) {
    constexpr uint32_t count = 100'000;
    const auto over_keys = [&](auto key_of) {
        std::vector<int> counts(cells * cells, 0);
        for (uint32_t i = 0; i < count; ++i) {
            const double a = PointList::random(key_of(i))[0].x;
            const double b = PointList::random(key_of(i + 1))[0].x;
            ++counts[size_t(int(a * cells) * cells + int(b * cells))];
        }
        expect_random(counts, count / 256.0);
    };
    over_keys([](uint32_t i) { return PointKey{0, i, 1}; });
    over_keys([](uint32_t i) { return PointKey{i, 0, 1}; });
    over_keys([](uint32_t i) { return PointKey{0, i / 2, i % 2}; });
}

TEST(PointList, KeysTellListsApart) {
    std::set<double> first;
    for (const PointKey& key : {PointKey{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}}) {
        first.insert(PointList::random(key)[0].x);
        first.insert(PointList::shifted_hammersley(16, key)[0].x);
        EXPECT_EQ(PointList::random(key)[7], PointList::random(key)[7]);
    }
    EXPECT_EQ(first.size(), 10u);
}

// Lists are parts of one long sequence; those of neighbouring directions must not overlap.
TEST(PointList, ListsHaveNoPointInCommon) {
    std::set<std::pair<double, double>> points;
    for (uint32_t direction = 0; direction < 50; ++direction)
        for (uint32_t i = 0; i < 200; ++i) {
            const Vec2d p = PointList::random({0, direction, 1})[i];
            points.emplace(p.x, p.y);
        }
    EXPECT_EQ(points.size(), 50u * 200u);
}

TEST(PointList, HammersleyIsMovedAsOne) {
    const PointList moved = PointList::shifted_hammersley(37, {5, 6, 7});
    const Vec2d offset = moved[0] - hammersley(0, 37);
    for (uint32_t i = 0; i < 37; ++i) {
        const Vec2d difference = moved[i] - hammersley(i, 37) - offset;
        EXPECT_NEAR(difference.x, std::round(difference.x), 1e-12) << i;
        EXPECT_NEAR(difference.y, std::round(difference.y), 1e-12) << i;
        EXPECT_EQ(PointList::hammersley(37)[i], hammersley(i, 37));
    }
}

// Cranley and Patterson's offset makes every single point uniform.
TEST(PointList, EveryMovedPointIsUniform) {
    constexpr uint32_t keys = 100'000;
    std::vector<int> counts(cells * cells, 0);
    for (uint32_t key = 0; key < keys; ++key) {
        const Vec2d p = PointList::shifted_hammersley(8, {0, key, 1})[5];
        ++counts[size_t(int(p.y * cells) * cells + int(p.x * cells))];
    }
    expect_random(counts, keys / 256.0);
}

}  // namespace
}  // namespace splitsum
