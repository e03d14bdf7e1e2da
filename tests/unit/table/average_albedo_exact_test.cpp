#include "splitsum/table/average_albedo_exact.h"

#include <gtest/gtest.h>

#include <cmath>

#include "splitsum/math/quadrature.h"
#include "splitsum/table/split_sum_exact.h"

namespace splitsum {
namespace {

// The definition, 2 ∫ E(mu) mu dmu, on panels that halve towards mu = 0.
double average_of_albedos(SmithTerm term, double alpha) {
    constexpr int panels = 9;
    const QuadratureRule rule = gauss_legendre(5);
    double sum = 0;
    for (int panel = 0; panel < panels; ++panel) {
        const double to = std::ldexp(1.0, -panel);
        sum += integrate(rule, panel + 1 < panels ? 0.5 * to : 0, to, [&](double mu) {
            const SplitSum at = split_sum_exact(term, mu, alpha);
            return 2 * mu * (at.a + at.b);
        });
    }
    return sum;
}

TEST(AverageAlbedoExact, IsTheAverageOfDirectionalAlbedos) {
    for (const SmithTermInfo& info : smith_terms())
        for (const double alpha : {1e-5, 1e-3, 0.01, 0.1, 0.3, 0.6, 1.0})
            EXPECT_NEAR(average_albedo_exact(info.term, alpha),
                        average_of_albedos(info.term, alpha), 1e-6)
                << info.name << " " << alpha;
}

TEST(AverageAlbedoExact, OfAMirrorIsOne) {
    for (const SmithTermInfo& info : smith_terms())
        EXPECT_EQ(average_albedo_exact(info.term, 0), 1);
}

}  // namespace
}  // namespace splitsum
