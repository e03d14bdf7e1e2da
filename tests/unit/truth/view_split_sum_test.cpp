#include "splitsum/truth/view_split_sum.h"

#include <gtest/gtest.h>

#include "splitsum/table/split_sum_exact.h"

namespace splitsum {
namespace {

TEST(ViewSplitSum, IsTheExactOne) {
    for (const double alpha : {0.0, 1e-6, 1e-3, 0.04, 0.36, 1.0}) {
        const ViewSplitSum split_sum(alpha);
        for (const double n_dot_v : {0.0, 1e-7, 0.9e-3, 1e-3, 1.1e-3, 0.0123, 0.2, 0.77, 1.0}) {
            const SplitSum found = split_sum.at(n_dot_v);
            const SplitSum exact = split_sum_exact(SmithTerm::height_correlated, n_dot_v, alpha);
            EXPECT_NEAR(found.a, exact.a, 1e-8) << alpha << ' ' << n_dot_v;
            EXPECT_NEAR(found.b, exact.b, 1e-8) << alpha << ' ' << n_dot_v;
        }
    }
}

}  // namespace
}  // namespace splitsum
