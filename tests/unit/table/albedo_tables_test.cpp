#include "splitsum/table/albedo_tables.h"

#include <gtest/gtest.h>

#include <cmath>

#include "splitsum/base/parallel.h"
#include "splitsum/table/kinds.h"
#include "splitsum/table/self_check.h"

namespace splitsum {
namespace {

constexpr const char* names[] = {"charlie", "charlie-clamped", "charlie-smith", "diffuse-disney",
                                 "diffuse-renormalised"};

TablePlan plan_of(const char* kind, int size) {
    TablePlan plan;
    plan.kind = kind;
    plan.size = size;
    plan.layout = TexelLayout::edge;
    return plan;
}

Table bake(const TablePlan& plan) {
    NoProgress progress;
    const auto kind = kind_of(plan);
    const auto table = kind->bake(plan, grid_of(plan, kind->view_axis), progress);
    EXPECT_TRUE(table) << table.error().message;
    return *table;
}

class EveryAlbedo : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Table, EveryAlbedo, testing::ValuesIn(names));

// The corners and edges among them, where n·v or roughness is 0. Measured: 6e-8 (the rounding to
// floats) but for the fitted Smith term, 2e-6.
TEST_P(EveryAlbedo, IsExactAtItsTexels) {
    for (const int size : {24, 80}) {  // the second is too large to integrate all of it
        const TablePlan plan = plan_of(GetParam(), size);
        const TableCheck check =
            check_table(*kind_of(plan), plan, bake(plan), {.texels = 64, .points = 0});
        EXPECT_LT(check.at_texels, 5e-6) << size;
        EXPECT_GT(check.texels, 64);
    }
}

TEST_P(EveryAlbedo, IsTheSameForEveryNumberOfThreads) {
    const auto with = [](int threads) {
        const ThreadLimit limit(threads);
        return bake(plan_of(GetParam(), 7)).values;
    };
    EXPECT_EQ(with(1), with(4));
}

TEST_P(EveryAlbedo, RefusesAMethodThatItDoesNotHave) {
    TablePlan plan = plan_of(GetParam(), 8);
    plan.method = "importance";
    const auto kind = kind_of(plan);
    ASSERT_FALSE(kind);
    EXPECT_EQ(kind.error().kind, ErrorKind::bad_argument);
}

}  // namespace
}  // namespace splitsum
