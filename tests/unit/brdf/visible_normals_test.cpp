#include "splitsum/brdf/visible_normals.h"

#include <gtest/gtest.h>

#include <cmath>

#include "splitsum/brdf/ggx.h"

namespace splitsum {
namespace {

Vec3d view_at(double cosine) { return {std::sqrt(1 - cosine * cosine), 0, cosine}; }

TEST(VisibleNormals, AreUnitAndFaceTheViewer) {
    for (const double alpha : {0.0, 1e-9, 1e-3, 0.2, 1.0})
        for (const double cosine : {1e-4, 0.02, 0.5, 1.0})
            for (double u = 0.05; u < 1; u += 0.1) {
                const Vec3d view = view_at(cosine);
                const Vec3d h = sample_visible_normal(view, {u, 1 - u}, alpha);
                EXPECT_NEAR(length(h), 1, 1e-14);
                EXPECT_GE(h.z, 0);
                EXPECT_GE(dot(view, h), -1e-14) << alpha << " " << cosine << " " << u;
            }
}

// Seen along the normal nothing is hidden: the visible normals are all normals.
TEST(VisibleNormals, SeenFromAboveAreAllNormals) {
    for (const double alpha : {1e-6, 0.3, 1.0})
        for (const double u : {0.1, 0.6, 0.95}) {
            const Vec3d h = sample_visible_normal({0, 0, 1}, {u, 0.3}, alpha);
            const Vec3d expected = sample_ggx_normal({u, 0.3}, alpha).normal;
            EXPECT_NEAR(length(h - expected), 0, 1e-14 + 1e-12 * alpha);
            EXPECT_NEAR(visible_normal_pdf({0, 0, 1}, h, alpha) / ggx_normal_pdf(h, alpha), 1,
                        1e-13);
        }
}

TEST(VisibleNormals, OfTheMirrorAreTheNormal) {
    const Vec3d h = sample_visible_normal(view_at(0.3), {0.9, 0.2}, 0);
    EXPECT_NEAR(length(h - Vec3d(0, 0, 1)), 0, 1e-15);
}

TEST(VisibleNormals, BelowTheSurfaceOrTurnedAwayHaveNoDensity) {
    EXPECT_EQ(visible_normal_pdf(view_at(0.5), {0.6, 0, -0.8}, 0.5), 0);
    EXPECT_EQ(visible_normal_pdf(view_at(0.1), {-0.8, 0, 0.6}, 0.5), 0);
}

}  // namespace
}  // namespace splitsum
