#include "splitsum/table/split_sum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "splitsum/base/parallel.h"
#include "splitsum/base/random.h"
#include "splitsum/base/text.h"
#include "splitsum/table/split_sum_exact.h"

namespace splitsum {
namespace {

struct Case {
    std::string_view method;
    SmithTerm geometry;
    /// Asked for of 1024 samples; measured over every second row and column of 512² texels: 0.0017
    /// (vndf), 0.040 (importance); of the quadrature at the default accuracy: 3e-8.
    double max_abs;
};

std::vector<Case> every_case() {
    std::vector<Case> cases;
    for (const SmithTermInfo& info : smith_terms()) {
        cases.push_back({"quadrature", info.term, default_table_accuracy});
        cases.push_back({"vndf", info.term, 5e-3});
        cases.push_back({"importance", info.term, 6e-2});
    }
    return cases;
}

TablePlan plan_of(const Case& at, int size, TexelLayout layout = TexelLayout::centre) {
    TablePlan plan;
    plan.method = at.method;
    plan.geometry = at.geometry;
    plan.size = size;
    plan.layout = layout;
    return plan;
}

double largest_error(const SplitSum& found, const SplitSum& exact) {
    return std::max(std::abs(found.a - exact.a), std::abs(found.b - exact.b));
}

// The rows and columns where bakers go wrong (the two smoothest and grazing-most, and the last), a
// grid between them, the corner where both are small, and texels nobody chose.
std::vector<std::pair<int, int>> texels_to_judge(int size) {
    std::vector<std::pair<int, int>> texels;
    for (const int line : {0, 1, size / 2, size - 1})
        for (int along = 0; along < size; along += 23) {
            texels.emplace_back(along, line);
            texels.emplace_back(line, along);
        }
    for (int x = 0; x < 5; ++x)
        for (int y = 0; y < 5; ++y) texels.emplace_back(x, y);
    for (uint32_t i = 0; i < 200; ++i)
        texels.emplace_back(static_cast<int>(unit_float(2 * i) * static_cast<float>(size)),
                            static_cast<int>(unit_float(2 * i + 1) * static_cast<float>(size)));
    return texels;
}

std::vector<SplitSum> sums_of(const TablePlan& plan, const TableGrid& grid) {
    NoProgress progress;
    const auto sums = split_sums(plan, grid, progress);
    EXPECT_TRUE(sums) << sums.error().message;
    return *sums;
}

void expect_within(const TablePlan& plan, double max_abs) {
    const TableGrid grid = grid_of(plan, ViewAxis::cosine);
    const auto sums = sums_of(plan, grid);
    const auto texels = texels_to_judge(plan.size);
    std::vector<double> errors(texels.size());
    parallel_rows(static_cast<int>(texels.size()), [&](int i) {
        const auto [x, y] = texels[static_cast<size_t>(i)];
        const double r = grid.perceptual_roughness[static_cast<size_t>(y)];
        errors[static_cast<size_t>(i)] = largest_error(
            sums[static_cast<size_t>(y * plan.size + x)],
            split_sum_exact(plan.geometry, grid.n_dot_v[static_cast<size_t>(x)], r * r));
    });
    for (size_t i = 0; i < texels.size(); ++i)
        EXPECT_LE(errors[i], max_abs) << "texel " << texels[i].first << ", " << texels[i].second;
}

class EveryMethod : public testing::TestWithParam<Case> {};

INSTANTIATE_TEST_SUITE_P(Table, EveryMethod, testing::ValuesIn(every_case()), [](const auto& at) {
    std::string name = cat(at.param.method, "_", info_of(at.param.geometry).name);
    std::ranges::replace(name, '-', '_');
    return name;
});

TEST_P(EveryMethod, IsWithinItsErrorEverywhere) {
    expect_within(plan_of(GetParam(), 512), GetParam().max_abs);
}

TEST_P(EveryMethod, IsRightAtBothEndsOfBothAxes) {
    const TablePlan plan = plan_of(GetParam(), 65, TexelLayout::edge);
    expect_within(plan, GetParam().max_abs);
    const auto sums = sums_of(plan, grid_of(plan, ViewAxis::cosine));
    for (int x = 0; x < 65; ++x) {  // the mirror is Fresnel, exactly
        EXPECT_NEAR(sums[size_t(x)].b, std::pow(1 - x / 64.0, 5), 1e-15);
        EXPECT_NEAR(sums[size_t(x)].a + sums[size_t(x)].b, 1, 1e-15);
    }
    // Seen edge on, every facet of a height-correlated surface that the viewer sees sends its light
    // above the horizon: nothing is lost.
    if (plan.geometry == SmithTerm::height_correlated && plan.method != "importance") {
        for (int y = 0; y < 65; ++y)
            EXPECT_NEAR(sums[size_t(65 * y)].a + sums[size_t(65 * y)].b, 1, GetParam().max_abs)
                << y;
    }
}

TEST_P(EveryMethod, IsTheSameForEveryNumberOfThreads) {
    TablePlan plan = plan_of(GetParam(), 133);
    plan.samples = 64;
    const TableGrid grid = grid_of(plan, ViewAxis::cosine);
    const auto with = [&](int threads) {
        const ThreadLimit limit(threads);
        return sums_of(plan, grid);
    };
    const auto one = with(1), four = with(4);
    for (size_t i = 0; i < one.size(); ++i) {
        ASSERT_EQ(one[i].a, four[i].a);
        ASSERT_EQ(one[i].b, four[i].b);
    }
}

// In a white furnace a surface of reflectance 1 returns a + b, at most 1.
TEST_P(EveryMethod, ReturnsNoMoreThanTheFurnaceGives) {
    if (GetParam().geometry != SmithTerm::height_correlated)
        return;  // Schlick's terms promise nothing
    const TablePlan plan = plan_of(GetParam(), 64);
    for (const SplitSum& sum : sums_of(plan, grid_of(plan, ViewAxis::cosine))) {
        EXPECT_LE(sum.a + sum.b, 1 + GetParam().max_abs);
        EXPECT_GE(sum.a, -GetParam().max_abs);
        EXPECT_GE(sum.b, 0);
    }
}

TEST(SplitSums, StopWhenCancelled) {
    struct Impatient final : Progress {
        void begin(std::string_view, int) override {}
        void advance(int) override {}
        bool cancelled() const override { return true; }
    } progress;
    for (const SplitSumMethod& method : split_sum_methods()) {
        TablePlan plan;
        plan.method = method.name;
        const auto sums = split_sums(plan, grid_of(plan, ViewAxis::cosine), progress);
        ASSERT_FALSE(sums);
        EXPECT_EQ(sums.error().kind, ErrorKind::interrupted);
    }
}

TEST(SplitSums, AnUnknownMethodIsToldWhatThereIs) {
    const auto method = find_split_sum_method("guess");
    ASSERT_FALSE(method);
    EXPECT_EQ(method.error().kind, ErrorKind::bad_argument);
    for (const SplitSumMethod& known : split_sum_methods())
        EXPECT_NE(method.error().message.find(known.name), std::string::npos);
}

}  // namespace
}  // namespace splitsum
