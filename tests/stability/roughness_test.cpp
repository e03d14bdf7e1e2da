// Rows 1, 2 and 3: no roughness at all, hardly any, and views that graze the surface.
#include "splitsum/measure/error_figures.h"
#include "splitsum/table/split_sum_exact.h"
#include "splitsum/table/split_sum_vndf.h"
#include "stability/levels.h"
#include "support/lopsided_sky.h"

namespace splitsum::tests {
namespace {

class Roughness : public EveryReflectionMethod {};
INSTANTIATE_TEST_SUITE_P(Methods, Roughness, testing::ValuesIn(reflection_methods()));

// On the way to 0 nothing must blow up, get lost in cancellation or jump: a widely used baker is
// 2.9 % off at 0.045 and 88 % at 0.02. The sky is smooth, so that the truth is known to every method
// to within its texels: `reference` differs from a lookup by half of one, 64 rows high.
TEST_P(Roughness, IsRightDownToNothing) {
    const Environment sky = lopsided_sky(64, 0);
    const std::vector<double> roughness = {0, 1e-4, 1e-3, 0.01, 0.045, 0.2, 1};
    const auto levels = levels_by(GetParam(), sky, roughness, 6);
    const auto truth = levels_by("reference", sky, roughness, 6);
    for (size_t i = 0; i < roughness.size(); ++i) {
        SCOPED_TRACE(roughness[i]);
        expect_light(levels[i]);
        const ErrorFigures figures = error_figures(levels[i].texels, truth[i].texels);
        EXPECT_LT(figures.rel_rms, 2e-2);
        EXPECT_LT(std::abs(figures.bias), 1e-2);
    }
}

// A level of roughness 1e-4 is the mirror image to within a texel of the panorama.
TEST_P(Roughness, NextToNothingIsTheMirror) {
    const Environment sky = lopsided_sky(64, 0);
    const auto levels = levels_by(GetParam(), sky, {0, 1e-4}, 8);
    EXPECT_LT(error_figures(levels[1].texels, levels[0].texels).rel_rms, 2e-2);
}

TEST(GrazingViews, AreFiniteAndRight) {
    for (const SmithTermInfo& geometry : smith_terms())
        for (const double n_dot_v : {1e-7, 1e-5, 1e-3, 0.01})
            for (const double alpha : {0.0, 1e-8, 1e-4, 0.0004, 0.01, 0.3, 1.0}) {
                const SplitSum sampled =
                    split_sum_by_visible_normals(geometry.term, n_dot_v, alpha, 1024);
                const SplitSum exact = split_sum_exact(geometry.term, n_dot_v, alpha);
                for (const SplitSum& sum : {sampled, exact}) {
                    ASSERT_TRUE(std::isfinite(sum.a) && std::isfinite(sum.b))
                        << geometry.name << " " << n_dot_v << " " << alpha;
                    ASSERT_GE(sum.a, 0);
                    ASSERT_GE(sum.b, 0);
                    ASSERT_LE(sum.a + sum.b, 1.05);  // Schlick's terms may exceed 1 a little
                }
                EXPECT_NEAR(sampled.a, exact.a, 5e-3) << geometry.name << n_dot_v << " " << alpha;
                EXPECT_NEAR(sampled.b, exact.b, 5e-3) << geometry.name << n_dot_v << " " << alpha;
            }
}

}  // namespace
}  // namespace splitsum::tests
