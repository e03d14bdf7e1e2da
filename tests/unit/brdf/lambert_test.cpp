#include "splitsum/brdf/lambert.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace splitsum {
namespace {

TEST(CosineSampling, InvertsTheDistributionFunction) {
    for (const double u : {0.0, 1e-9, 0.25, 0.8}) {
        const Vec3d d = sample_cosine_direction({u, 0.1});
        EXPECT_NEAR(length(d), 1, 1e-15);
        EXPECT_NEAR(d.x * d.x + d.y * d.y, u, 1e-15);
    }
}

TEST(CosineSampling, AzimuthTurnsFromXTowardsY) {
    const Vec3d d = sample_cosine_direction({0.5, 0.25});
    EXPECT_NEAR(d.x, 0, 1e-15);
    EXPECT_GT(d.y, 0.5);
}

TEST(CosineDirectionPdf, IsZeroBelowTheHorizon) {
    EXPECT_EQ(cosine_direction_pdf(-0.3), 0);
    EXPECT_NEAR(cosine_direction_pdf(1), 1 / std::numbers::pi, 1e-15);
}

}  // namespace
}  // namespace splitsum
