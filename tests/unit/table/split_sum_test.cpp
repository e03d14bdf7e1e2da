#include "splitsum/table/split_sum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "splitsum/base/parallel.h"
#include "splitsum/base/random.h"
#include "splitsum/table/split_sum_exact.h"

namespace splitsum {
namespace {

// Asked for by the product; measured over every second row and column of the three tables:
// 0.0017.
constexpr double max_abs_of_1024_samples = 5e-3;

Table table_of(const TablePlan& plan) {
    NoProgress progress;
    auto table = split_sum_table(plan, progress);
    EXPECT_TRUE(table) << table.error().message;
    return *table;
}

double largest_error(const SplitSum& found, const SplitSum& exact) {
    return std::max(std::abs(found.a - exact.a), std::abs(found.b - exact.b));
}

// The rows and columns where bakers go wrong (the two smoothest and grazing-most, and the last), a
// grid between them, and texels nobody chose.
std::vector<std::pair<int, int>> texels_to_judge(int size) {
    std::vector<int> lines = {0, 1, size / 2, size - 1};
    std::vector<std::pair<int, int>> texels;
    for (const int line : lines)
        for (int along = 0; along < size; along += 23) {
            texels.emplace_back(along, line);
            texels.emplace_back(line, along);
        }
    for (uint32_t i = 0; i < 200; ++i)
        texels.emplace_back(static_cast<int>(unit_float(2 * i) * static_cast<float>(size)),
                            static_cast<int>(unit_float(2 * i + 1) * static_cast<float>(size)));
    return texels;
}

class EverySmithTerm : public testing::TestWithParam<SmithTerm> {};

INSTANTIATE_TEST_SUITE_P(Table, EverySmithTerm,
                         testing::Values(SmithTerm::height_correlated, SmithTerm::schlick_half,
                                         SmithTerm::schlick_sqrt));

TEST_P(EverySmithTerm, TableOf1024SamplesIsWithinTheStatedErrorEverywhere) {
    const TablePlan plan{.size = 512, .samples = 1024, .geometry = GetParam()};
    const Table table = table_of(plan);
    const auto texels = texels_to_judge(plan.size);
    std::vector<double> errors(texels.size());
    parallel_rows(static_cast<int>(texels.size()), [&](int i) {
        const auto [x, y] = texels[static_cast<size_t>(i)];
        const double perceptual_roughness = (y + 0.5) / plan.size;
        const Vec2& texel = table.texels[static_cast<size_t>(y * plan.size + x)];
        errors[static_cast<size_t>(i)] =
            largest_error({static_cast<double>(texel.x), static_cast<double>(texel.y)},
                          split_sum_exact(plan.geometry, (x + 0.5) / plan.size,
                                          perceptual_roughness * perceptual_roughness));
    });
    for (size_t i = 0; i < texels.size(); ++i)
        EXPECT_LE(errors[i], max_abs_of_1024_samples)
            << "texel " << texels[i].first << ", " << texels[i].second;
    RecordProperty("max_abs", std::to_string(*std::max_element(errors.begin(), errors.end())));
}

TEST_P(EverySmithTerm, ErrorFallsWithTheSamples) {
    const auto error_of = [&](int samples) {
        double worst = 0;
        for (const double alpha : {0.01, 0.2, 0.6, 1.0})
            for (const double n_dot_v : {0.01, 0.2, 0.6, 0.95})
                worst = std::max(
                    worst, largest_error(split_sum_by_sampling(GetParam(), n_dot_v, alpha, samples),
                                         split_sum_exact(GetParam(), n_dot_v, alpha)));
        return worst;
    };
    EXPECT_LT(error_of(1000), 5e-3);  // not a power of two, and not a multiple of the SIMD width
    EXPECT_LT(error_of(65536), 5e-5);
    EXPECT_LT(error_of(1 << 20), 5e-6);
}

TEST_P(EverySmithTerm, TinyRoughnessAndGrazingViewsStayFiniteAndRight) {
    for (const double alpha : {0.0, 1e-14, 1e-9, 1e-6, 1e-4, 1e-2, 1.0})
        for (const double n_dot_v : {1e-6, 1e-4, 1e-3, 0.1, 1.0}) {
            const SplitSum sum = split_sum_by_sampling(GetParam(), n_dot_v, alpha, 1024);
            ASSERT_TRUE(std::isfinite(sum.a) && std::isfinite(sum.b)) << alpha << " " << n_dot_v;
            if (alpha > 0 && (alpha < 1e-6 || n_dot_v < 1e-4)) continue;
            EXPECT_LE(largest_error(sum, split_sum_exact(GetParam(), n_dot_v, alpha)), 5e-3)
                << "alpha " << alpha << ", n.v " << n_dot_v;
        }
}

TEST_P(EverySmithTerm, TheMirrorIsExact) {
    for (const double n_dot_v : {1e-4, 0.3, 1.0}) {
        const SplitSum mirror = split_sum_by_sampling(GetParam(), n_dot_v, 0, 7);
        EXPECT_NEAR(mirror.b, std::pow(1 - n_dot_v, 5), 1e-15);
        EXPECT_NEAR(mirror.a + mirror.b, 1, 1e-15);
    }
}

TEST(SplitSumTable, TexelsAreAtTheirCentres) {
    const TablePlan plan{.size = 5, .samples = 256};
    const Table table = table_of(plan);
    ASSERT_EQ(table.width, 5);
    ASSERT_EQ(table.height, 5);
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 5; ++x) {
            const double perceptual_roughness = (y + 0.5) / 5;
            const SplitSum sum =
                split_sum_by_sampling(plan.geometry, (x + 0.5) / 5,
                                      perceptual_roughness * perceptual_roughness, plan.samples);
            const Vec2& texel = table.texels[static_cast<size_t>(5 * y + x)];
            EXPECT_EQ(texel.x, static_cast<float>(sum.a));
            EXPECT_EQ(texel.y, static_cast<float>(sum.b));
        }
}

// In a white furnace a surface of reflectance 1 returns a + b, at most 1: every sample's weight is
// G2 / G1 <= 1.
TEST(SplitSumTable, ReturnsNoMoreThanTheFurnaceGives) {
    for (const Vec2& texel : table_of({.size = 64, .samples = 1024}).texels) {
        EXPECT_LE(texel.x + texel.y, 1 + 1e-6F);
        EXPECT_GE(texel.x, 0);
        EXPECT_GE(texel.y, 0);
    }
}

TEST(SplitSumTable, IsTheSameForEveryNumberOfThreads) {
    const TablePlan plan{.size = 33, .samples = 100};
    const auto bits_with = [&](int threads) {
        const ThreadLimit limit(threads);
        return table_of(plan).texels;
    };
    EXPECT_EQ(bits_with(1), bits_with(4));
}

TEST(SplitSumTable, RefusesAnImpossiblePlan) {
    NoProgress progress;
    const auto table = split_sum_table({.size = 0}, progress);
    ASSERT_FALSE(table);
    EXPECT_EQ(table.error().kind, ErrorKind::bad_argument);
}

TEST(SplitSumTable, StopsWhenCancelled) {
    struct Impatient final : Progress {
        void begin(std::string_view, int) override {}
        void advance(int) override {}
        bool cancelled() const override { return true; }
    } progress;
    const auto table = split_sum_table({}, progress);
    ASSERT_FALSE(table);
    EXPECT_EQ(table.error().kind, ErrorKind::interrupted);
}

}  // namespace
}  // namespace splitsum
