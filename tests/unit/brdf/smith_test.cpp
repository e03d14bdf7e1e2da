#include "splitsum/brdf/smith.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace splitsum {
namespace {

TEST(SmithTerms, AreNamedOnceAndTheDefaultComesFirst) {
    std::set<std::string_view> names;
    for (const SmithTermInfo& info : smith_terms()) {
        names.insert(info.name);
        EXPECT_EQ(info_of(info.term).name, info.name);
    }
    EXPECT_EQ(names.size(), smith_terms().size());
    EXPECT_EQ(smith_terms().front().term, SmithTerm::height_correlated);
}

TEST(SmithVisibility, IsReciprocalAndBounded) {
    for (const SmithTermInfo& info : smith_terms())
        for (const double alpha : {0.0, 1e-6, 0.04, 0.5, 1.0})
            for (const double l : {1e-5, 0.1, 0.6, 1.0})
                for (const double v : {1e-5, 0.2, 0.7, 1.0}) {
                    const double visibility = smith_visibility(info.term, l, v, alpha);
                    EXPECT_DOUBLE_EQ(visibility, smith_visibility(info.term, v, l, alpha));
                    EXPECT_GT(visibility, 0);
                    EXPECT_LE(4 * l * v * visibility, 1 + 1e-12) << info.name << " " << alpha;
                }
}

TEST(SmithVisibility, OfTheMirrorShadowsNothing) {
    for (const SmithTermInfo& info : smith_terms())
        EXPECT_NEAR(smith_visibility(info.term, 0.3, 0.8, 0), 1 / (4 * 0.3 * 0.8), 1e-14);
}

// Heitz 2014, eq. 72 and 99: G2 = 1 / (1 + Lambda(l) + Lambda(v)),
// Lambda = (sqrt(1 + alpha² tan²) - 1) / 2.
TEST(SmithVisibility, HeightCorrelatedIsHeitzs) {
    const auto lambda = [](double cosine, double alpha) {
        const double tan2 = (1 - cosine * cosine) / (cosine * cosine);
        return 0.5 * (std::sqrt(1 + alpha * alpha * tan2) - 1);
    };
    for (const double alpha : {0.01, 0.3, 1.0})
        for (const double l : {0.05, 0.5, 1.0})
            for (const double v : {0.02, 0.9}) {
                const double g2 = 1 / (1 + lambda(l, alpha) + lambda(v, alpha));
                const double v_form = smith_visibility(SmithTerm::height_correlated, l, v, alpha);
                EXPECT_NEAR(4 * l * v * v_form, g2, 1e-13);
            }
}

TEST(SmithVisibility, SchlickTermsUseTheirK) {
    const double alpha = 0.36;
    const auto g1 = [](double c, double k) { return c / (c * (1 - k) + k); };
    const auto g = [&](SmithTerm term) {
        return 4 * 0.3 * 0.8 * smith_visibility(term, 0.3, 0.8, alpha);
    };
    const double half = 0.5 * alpha;
    const double root = alpha * std::sqrt(2 / 3.14159265358979);
    EXPECT_NEAR(g(SmithTerm::schlick_half), g1(0.3, half) * g1(0.8, half), 1e-13);
    EXPECT_NEAR(g(SmithTerm::schlick_sqrt), g1(0.3, root) * g1(0.8, root), 1e-13);
}

}  // namespace
}  // namespace splitsum
