#include "splitsum/brdf/charlie.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "splitsum/math/tanh_sinh.h"

namespace splitsum {
namespace {

TEST(CharlieDensity, CoversTheSurfaceOnce) {
    for (const double alpha : {1e-3, 0.01, 0.2, 1.0}) {
        double sum = 0;
        for (const UnitNode& node : tanh_sinh(1.0 / 32)) {
            // Over sin² theta: d(sin²) = 2 sin cos dtheta.
            sum += node.weight * std::numbers::pi * charlie_density(node.from_start, alpha);
        }
        EXPECT_NEAR(sum, 1, 1e-9) << alpha;
    }
}

TEST(ClothVisibility, TermsAreNamedOnceAndTheDefaultComesFirst) {
    std::set<std::string_view> names;
    for (const ClothVisibilityInfo& info : cloth_visibilities()) names.insert(info.name);
    EXPECT_EQ(names.size(), 3u);
    EXPECT_EQ(cloth_visibilities().front().visibility, ClothVisibility::neubelt);
}

TEST(ClothVisibility, IsReciprocal) {
    for (const ClothVisibilityInfo& info : cloth_visibilities())
        for (const double alpha : {1e-4, 0.1, 1.0})
            for (const double l : {1e-3, 0.4, 1.0})
                for (const double v : {2e-3, 0.7})
                    EXPECT_NEAR(cloth_visibility(info.visibility, l, v, alpha) /
                                    cloth_visibility(info.visibility, v, l, alpha),
                                1, 1e-14);
}

TEST(ClothVisibility, OfNeubeltIsAQuarterAlongTheNormalAndClampsWhereAsked) {
    EXPECT_DOUBLE_EQ(cloth_visibility(ClothVisibility::neubelt, 1, 0.3, 0.5), 0.25);
    EXPECT_DOUBLE_EQ(cloth_visibility(ClothVisibility::neubelt, 0.1, 0.1, 0.5), 0.25 / 0.19);
    EXPECT_DOUBLE_EQ(cloth_visibility(ClothVisibility::neubelt_clamped, 0.1, 0.1, 0.5), 1);
}

// The fit is mirrored in its logarithm about 1/2, where both halves meet.
TEST(CharlieLambda, IsContinuousAndFallsToTheNormal) {
    for (const double alpha : {0.0, 0.25, 1.0}) {
        EXPECT_NEAR(charlie_lambda(0.5 - 1e-9, alpha), charlie_lambda(0.5, alpha), 1e-6);
        double before = charlie_lambda(1e-3, alpha);
        for (double cosine = 0.01; cosine <= 1; cosine += 0.01) {
            EXPECT_LT(charlie_lambda(cosine, alpha), before) << alpha << " " << cosine;
            before = charlie_lambda(cosine, alpha);
        }
    }
}

// Table 1 of the paper, a / (1 + b x^c) + d x + e at a cosine of 1/4.
TEST(CharlieLambda, IsTheFitOfThePaper) {
    const auto log_at_a_quarter = [](double a, double b, double c, double d, double e) {
        return a / (1 + b * std::pow(0.25, c)) + d * 0.25 + e;
    };
    EXPECT_NEAR(std::log(charlie_lambda(0.25, 0)),
                log_at_a_quarter(25.3245, 3.32435, 0.16801, -1.27393, -4.85967), 1e-12);
    EXPECT_NEAR(std::log(charlie_lambda(0.25, 1)),
                log_at_a_quarter(21.5473, 3.82987, 0.19823, -1.97760, -4.32054), 1e-12);
}

}  // namespace
}  // namespace splitsum
