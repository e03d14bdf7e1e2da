#include "splitsum/table/ltc_tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "splitsum/table/kinds.h"
#include "splitsum/table/split_sum_exact.h"
#include "support/polygon_lights.h"

namespace splitsum {
namespace {

using Polygon = std::vector<Vec3d>;

TablePlan plan_of(const char* kind) { return default_plan(*kind_of({.kind = kind})); }

Table bake(const TablePlan& plan) {
    NoProgress progress;
    const auto kind = kind_of(plan);
    const auto table = kind->bake(plan, grid_of(plan, kind->view_axis), progress);
    EXPECT_TRUE(table) << table.error().message;
    return arranged(*table, plan);
}

// As engines read them without being told anything (three.js, Bevy).
TEST(LtcTables, DefaultsAreWhatEnginesExpect) {
    for (const char* name : {"ltc-ggx", "ltc-disney"}) {
        const TablePlan plan = plan_of(name);
        EXPECT_EQ(plan.kind, name);
        EXPECT_EQ(plan.size, 64);
        EXPECT_EQ(plan.layout, TexelLayout::edge);
        EXPECT_EQ(plan.axes, TableAxes::roughness_nv);
        EXPECT_EQ(kind_of(plan)->view_axis, ViewAxis::sqrt_one_minus_cosine);
    }
}

// The product asks for 2 % (rms), which is met over more scenes (ltc/README.md). Measured on these: GGX
// 0.422 % of the radiance and 2.065 % of the shaded value (the tables published with the paper: 1.8 %
// and 8.7 %), Disney diffuse 0.061 % and 0.33 %. With the albedo for a magnitude GGX has
// 2.094 %, without straightening between views 2.074 %, with the albedo at n·v = 0 as it is 2.086 %.
TEST(LtcTables, ShadePolygonsAsIntegrationDoes) {
    for (const auto& [name, target, rms, rel_rms] :
         {std::tuple("ltc-ggx", LtcTarget::ggx, 0.0043, 0.0207),
          std::tuple("ltc-disney", LtcTarget::disney_diffuse, 0.002, 0.006)}) {
        const TablePlan plan = plan_of(name);
        const ShadingErrors errors = shading_errors(bake(plan), plan, target);
        RecordProperty(std::string(name) + " rms", std::to_string(errors.rms));
        RecordProperty(std::string(name) + " rel_rms", std::to_string(errors.rel_rms));
        EXPECT_LT(errors.rms, rms) << name;
        EXPECT_LT(errors.rel_rms, rel_rms) << name;
    }
}

// The test above must be able to fail: read with its axes the other way round, or with the lobe of a
// surface 10 % rougher, the same table misses.
TEST(LtcTables, TheTestNoticesWrongAxesAndAWrongWidth) {
    const TablePlan plan = plan_of("ltc-ggx");
    const Table table = bake(plan);
    TablePlan swapped = plan;
    swapped.axes = TableAxes::nv_roughness;
    EXPECT_GT(shading_errors(table, swapped, LtcTarget::ggx).rel_rms, 0.3);

    Table wider = table;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            std::ranges::copy(table.texel(std::min(63, x + 3), y, 0), wider.texel(x, y, 0).begin());
    EXPECT_GT(shading_errors(wider, plan, LtcTarget::ggx).rel_rms, 0.035);
}

TEST(LtcTables, HoldTheSplitSumAndTheSphere) {
    const Table table = bake(plan_of("ltc-ggx"));
    // r = 0, n·v = 0.
    EXPECT_NEAR(table.texel(0, 63, 1)[0], 1, 1e-5F);
    // (1 - n·v)^5 as a line through its last interval, which ends at 0.997.
    EXPECT_NEAR(table.texel(0, 63, 1)[1], 1, 4e-3F);
    // The whole sky about a centre at 90 degrees, half of it; a point overhead, all of it.
    EXPECT_NEAR(table.texel(0, 63, 1)[3], 0, 1e-6F);
    EXPECT_NEAR(table.texel(63, 63, 1)[3], 1, 1e-6F);
    EXPECT_NEAR(table.texel(32, 63, 1)[3], 0.5F * (1 + 1.0F / 63), 1e-6F);
    EXPECT_NEAR(table.texel(48, 0, 1)[3], 2 * 48 / 63.0F - 1, 1e-5F);
}

// As a fit wants it, within the one per cent that the documentation states; both sums alike. At n·v = 0
// they are what makes the last interval right.
TEST(LtcTables, HoldTheSplitSumToOnePerCent) {
    const Table table = bake(plan_of("ltc-ggx"));
    double most = 0;
    for (int y = 0; y < 63; ++y)
        for (int x = 1; x < 64; ++x) {
            const double r = x / 63.0, t = y / 63.0;
            const SplitSum sum = split_sum_exact(SmithTerm::height_correlated, 1 - t * t, r * r);
            const double magnitude = static_cast<double>(table.texel(x, y, 1)[0]) / (sum.a + sum.b);
            EXPECT_NEAR(static_cast<double>(table.texel(x, y, 1)[1]), magnitude * sum.b, 1e-5);
            most = std::max(most, std::abs(magnitude - 1));
        }
    EXPECT_LT(most, 0.01 + 1e-5);
    EXPECT_GT(most, 0.005);
}

// Entries may jump where the rows of mirrors end (ltc_between.h), what a light sees does not.
TEST(LtcTables, ShadeAlikeOnBothSidesOfTheMirrorRows) {
    const TablePlan plan = plan_of("ltc-ggx");
    const Table table = bake(plan);
    const Polygon panel = {
        {-1.5, -0.6, 0.05}, {-1.3, 0.9, 0.05}, {-0.9, 0.8, 1.4}, {-1.1, -0.7, 1.5}};
    for (const double n_dot_v : {0.15, 0.3, 0.6, 0.8})
        for (const double step : {0.5, 1.0, 1.5, 2.0, 2.5, 3.0})
            EXPECT_NEAR(shaded(table, plan, {panel, n_dot_v, step / 63}), 1, 5e-3)
                << n_dot_v << " " << step;
}

// The lobe is the judge of tables, so it has judges of its own: the whole sky is the albedo, and a
// narrow lobe sees all of a light around its mirror direction and none of one beside it.
TEST(PolygonLightReference, KnowsTheWholeSkyAndTheMirror) {
    for (const double n_dot_v : {0.05, 0.4, 0.9})
        for (const double r : {0.1, 0.5, 1.0}) {
            const TargetLobe lobe(LtcTarget::ggx, n_dot_v, r);
            double sky = 0;
            for (const double x : {-1.0, 1.0})
                for (const double y : {-1.0, 1.0})
                    sky += polygon_light_reference(lobe, Polygon{{x, 0, 0}, {0, y, 0}, {0, 0, 1}});
            const SplitSum sum = split_sum_exact(SmithTerm::height_correlated, n_dot_v, r * r);
            EXPECT_NEAR(sky, sum.a + sum.b, 1e-5) << n_dot_v << " " << r;
        }
    const TargetLobe mirror(LtcTarget::ggx, 0.6, 0.01);
    const Polygon around = {
        {-0.85, 0.1, 0.5}, {-0.85, -0.1, 0.5}, {-0.7, -0.1, 0.7}, {-0.7, 0.1, 0.7}};
    const Polygon beside = {
        {-0.85, 0.3, 0.5}, {-0.85, 0.1, 0.5}, {-0.7, 0.1, 0.7}, {-0.7, 0.3, 0.7}};
    EXPECT_NEAR(polygon_light_reference(mirror, around), 1, 1e-3);
    EXPECT_NEAR(polygon_light_reference(mirror, beside), 0, 1e-3);
}

}  // namespace
}  // namespace splitsum
