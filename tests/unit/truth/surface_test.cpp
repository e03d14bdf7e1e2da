#include "splitsum/truth/surface.h"

#include <gtest/gtest.h>

#include "surfaces.h"

namespace splitsum {
namespace {

TEST(Surface, IsAMirrorWhereItsLobeIsTooNarrow) {
    EXPECT_EQ(alpha_of({Vec3d(1), 1, 0}), 0);
    EXPECT_EQ(alpha_of({Vec3d(1), 1, 3e-4}), 0);
    EXPECT_EQ(alpha_of({Vec3d(1), 1, 1e-3}), 1e-6);
    EXPECT_EQ(alpha_of({Vec3d(1), 1, 0.5}), 0.25);
}

TEST(Surface, MirrorsTheViewAboutTheNormal) {
    const Vec3d normal(0.36, 0.48, -0.8);
    const Vec3d view = normalize(normal + Vec3d(0.3, -0.2, 0.5));
    const Surface surface = surface_of({}, ViewSplitSum(0.25), normal, view);
    const Vec3d mirrored = 2 * dot(normal, view) * normal - view;
    EXPECT_LT(length(mirrored_view(surface) - mirrored), 1e-14);
    EXPECT_NEAR(surface.view.z, dot(normal, view), 1e-15);
    EXPECT_NEAR(length(surface.view), 1, 1e-15);
}

TEST(Surface, CountsViewsFromBehindAsGrazing) {
    const Vec3d normal(0, 1, 0);
    const Surface surface =
        surface_of({}, ViewSplitSum(0.25), normal, normalize(Vec3d(0.8, -1e-9, 0.6)));
    EXPECT_EQ(surface.view.z, 0);
    EXPECT_NEAR(length(surface.view), 1, 1e-15);
    EXPECT_GT(surface.response.reflectance.x, 0);
}

}  // namespace
}  // namespace splitsum
