#include "splitsum/plan/asset_plan.h"

#include <gtest/gtest.h>

#include <cmath>

namespace splitsum {
namespace {

template <class Plan>
void expect_refused(const Plan& plan, const char* found) {
    const Status status = validate(plan);
    ASSERT_FALSE(status) << found;
    EXPECT_EQ(status.error().kind, ErrorKind::bad_argument);
    EXPECT_NE(status.error().message.find(found), std::string::npos) << status.error().message;
}

TEST(AssetPlan, DefaultsAreValid) {
    EXPECT_TRUE(validate(FilterPlan{}));
    EXPECT_TRUE(validate(SpecularPlan{}));
    EXPECT_TRUE(validate(IrradiancePlan{}));
    EXPECT_TRUE(validate(TablePlan{}));
}

TEST(AssetPlan, LimitsAreInclusive) {
    EXPECT_TRUE(validate(SpecularPlan{.face_size = 1, .levels = 1, .roughness = {}}));
    EXPECT_TRUE(validate(SpecularPlan{.face_size = 8192, .levels = 14, .roughness = {}}));
    EXPECT_TRUE(validate(TablePlan{.size = 1, .samples = 1, .accuracy = 1e-7}));
    EXPECT_TRUE(validate(IrradiancePlan{.face_size = 1, .harmonics_order = 0}));
}

TEST(AssetPlan, RefusesNumbersOutOfRangeAndNamesThem) {
    expect_refused(FilterPlan{.samples = 0}, "got 0");
    expect_refused(FilterPlan{.method = ""}, "no filter method");
    expect_refused(SpecularPlan{.face_size = 8193, .levels = 1, .roughness = {}}, "got 8193");
    expect_refused(SpecularPlan{.face_size = 0, .levels = 1, .roughness = {}}, "got 0");
    expect_refused(IrradiancePlan{.harmonics_order = -1}, "got -1");
    expect_refused(TablePlan{.size = -4}, "got -4");
    expect_refused(TablePlan{.samples = 0}, "got 0");
    expect_refused(TablePlan{.accuracy = 1e-8}, "got 1e-08");
    expect_refused(TablePlan{.accuracy = std::nan("")}, "got nan");
    expect_refused(TablePlan{.size = TablePlan::automatic_size}, "1e-3");
    expect_refused(TablePlan{.size = 1, .layout = TexelLayout::edge}, "got 1");
}

TEST(AssetPlan, AChainEndsAtOneTexel) {
    EXPECT_TRUE(validate(SpecularPlan{.face_size = 100, .levels = 7, .roughness = {}}));
    expect_refused(SpecularPlan{.face_size = 100, .levels = 8, .roughness = {}}, "got 8");
    expect_refused(SpecularPlan{.face_size = 64, .levels = 0, .roughness = {}}, "got 0");
}

TEST(AssetPlan, AListNamesEveryLevel) {
    SpecularPlan plan{.face_size = 64, .levels = 3, .roughness = {}};
    plan.roughness = {RoughnessCurve::Kind::list, {0, 0.5, 1}};
    EXPECT_TRUE(validate(plan));
    plan.levels = 4;
    expect_refused(plan, "3 levels and the chain has 4");
    plan.levels = 3;
    plan.roughness.list = {0, 0.7, 0.5};
    expect_refused(plan, "got 0.5 after 0.7");
}

}  // namespace
}  // namespace splitsum
