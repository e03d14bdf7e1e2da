#include "splitsum/preview/look_up_table.h"

#include <gtest/gtest.h>

#include "splitsum/table/bilinear.h"
#include "splitsum/table/split_sum_lookup.h"

namespace splitsum {
namespace {

// Not square and without a symmetry.
Table canonical(bool multiscatter, int channels = 2) {
    Table table = blank_table(7, 7, channels);
    for (int y = 0; y < 7; ++y)
        for (int x = 0; x < 7; ++x) {
            const float a = 0.3f + 0.05f * float(x) - 0.02f * float(y * y),
                        b = 0.01f * float(x * y);
            table.texel(x, y)[0] = multiscatter ? b : a;
            table.texel(x, y)[1] = multiscatter ? a + b : b;
        }
    return table;
}

// What an engine reads from the file by its conventions is what look_up() reads from ours.
TEST(LookUpTable, ReadsTheSameBetweenTexelsInEveryArrangement) {
    for (const bool multiscatter : {false, true})
        for (const TableAxes axes : {TableAxes::nv_roughness, TableAxes::roughness_nv})
            for (const bool flip : {false, true}) {
                TablePlan plan;
                plan.kind = multiscatter ? "ggx-multiscatter" : "ggx";
                plan.axes = axes;
                plan.flip = flip;
                const Table stored = arranged(canonical(multiscatter, 4), plan);
                const auto table = look_up_table(stored, plan);
                ASSERT_TRUE(table) << table.error().message;
                for (double n_dot_v = 0; n_dot_v <= 1; n_dot_v += 0.09)
                    for (double r = 0; r <= 1; r += 0.11) {
                        double read[4];
                        read_bilinear(stored,
                                      texture_coordinates(plan, 7, ViewAxis::cosine, n_dot_v, r),
                                      read);
                        const SplitSum meant = multiscatter
                                                   ? split_sum_of_multiscatter(read[0], read[1])
                                                   : SplitSum{read[0], read[1]};
                        const SplitSum found = look_up(*table, n_dot_v, r);
                        EXPECT_NEAR(found.a, meant.a, 1e-6);
                        EXPECT_NEAR(found.b, meant.b, 1e-6);
                    }
            }
}

TEST(LookUpTable, RefusesWhatLookUpWouldMisread) {
    const auto refused = [](const TablePlan& plan, const char* says) {
        const auto table = look_up_table(canonical(false), plan);
        ASSERT_FALSE(table);
        EXPECT_EQ(table.error().kind, ErrorKind::unusable_input);
        EXPECT_NE(table.error().message.find(says), std::string::npos) << table.error().message;
        EXPECT_NE(table.error().message.find("splitsum-brdf"), std::string::npos);
    };
    TablePlan edge, alpha, cloth;
    edge.layout = TexelLayout::edge;
    alpha.roughness_axis = RoughnessAxis::alpha;
    cloth.kind = "charlie";
    refused(edge, "edges");
    refused(alpha, "alpha");
    refused(cloth, "'charlie'");
    EXPECT_FALSE(look_up_table(blank_table(4, 4, 2, 2), {}));
    EXPECT_FALSE(look_up_table(blank_table(4, 4, 1), {}));
}

}  // namespace
}  // namespace splitsum
