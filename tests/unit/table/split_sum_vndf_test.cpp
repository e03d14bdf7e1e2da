#include "splitsum/table/split_sum_vndf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "splitsum/table/split_sum_exact.h"

namespace splitsum {
namespace {

double largest_error(const SplitSum& found, const SplitSum& exact) {
    return std::max(std::abs(found.a - exact.a), std::abs(found.b - exact.b));
}

class EverySmithTerm : public testing::TestWithParam<SmithTerm> {};

INSTANTIATE_TEST_SUITE_P(Table, EverySmithTerm,
                         testing::Values(SmithTerm::height_correlated, SmithTerm::schlick_half,
                                         SmithTerm::schlick_sqrt));

TEST_P(EverySmithTerm, ErrorFallsWithTheSamples) {
    const auto error_of = [&](int samples) {
        double worst = 0;
        for (const double alpha : {0.01, 0.2, 0.6, 1.0})
            for (const double n_dot_v : {0.01, 0.2, 0.6, 0.95})
                worst = std::max(worst, largest_error(split_sum_by_visible_normals(
                                                          GetParam(), n_dot_v, alpha, samples),
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
            const SplitSum sum = split_sum_by_visible_normals(GetParam(), n_dot_v, alpha, 1024);
            ASSERT_TRUE(std::isfinite(sum.a) && std::isfinite(sum.b)) << alpha << " " << n_dot_v;
            if (alpha > 0 && (alpha < 1e-6 || n_dot_v < 1e-4)) continue;
            EXPECT_LE(largest_error(sum, split_sum_exact(GetParam(), n_dot_v, alpha)), 5e-3)
                << "alpha " << alpha << ", n.v " << n_dot_v;
        }
}

TEST_P(EverySmithTerm, TheMirrorIsExact) {
    for (const double n_dot_v : {1e-4, 0.3, 1.0}) {
        const SplitSum mirror = split_sum_by_visible_normals(GetParam(), n_dot_v, 0, 7);
        EXPECT_NEAR(mirror.b, std::pow(1 - n_dot_v, 5), 1e-15);
        EXPECT_NEAR(mirror.a + mirror.b, 1, 1e-15);
    }
}

}  // namespace
}  // namespace splitsum
