#include "splitsum/shading/surface.h"

#include <gtest/gtest.h>

namespace splitsum {
namespace {

// The split sum of some rough surface: it loses light between the microfacets, a + b < 1.
constexpr SplitSum lossy{0.7, 0.1};

TEST(SurfaceResponse, WhiteSurfacesGiveAWhiteFurnaceBack) {
    for (const double metalness : {0.0, 0.4, 1.0}) {
        const SurfaceResponse white = response_of(Vec3d(1), metalness, lossy);
        const Vec3d seen =
            image_based_light(Vec3d(1), Vec3d(1), white.reflectance, white.diffuse_albedo);
        if (metalness == 0 || metalness == 1)
            EXPECT_LT(length(seen - Vec3d(1)), 1e-12) << metalness;
        else
            EXPECT_LT(seen.x, 1) << "between the two, part of neither";
    }
}

TEST(SurfaceResponse, MetalsColourWhatTheyReflectAndHaveNothingBelow) {
    const Vec3d gold(1, 0.8, 0.3);
    const SurfaceResponse metal = response_of(gold, 1, lossy);
    EXPECT_EQ(metal.f0, gold);
    EXPECT_EQ(metal.diffuse_albedo, Vec3d(0));
    EXPECT_GT(metal.reflectance.x, metal.reflectance.y);
    EXPECT_GT(metal.reflectance.y, metal.reflectance.z);
}

TEST(SurfaceResponse, DielectricsReflectWithoutColour) {
    const SurfaceResponse plastic = response_of({0.9, 0.1, 0.5}, 0, lossy);
    EXPECT_EQ(plastic.f0, Vec3d(dielectric_f0));
    EXPECT_NEAR(plastic.diffuse_albedo.x / plastic.diffuse_albedo.y, 9, 1e-12);
    EXPECT_NEAR(plastic.compensation.z, 1 + 0.04 * (1 / 0.8 - 1), 1e-12);
}

// An index of refraction of 1.5: ((1.5 - 1) / (1.5 + 1))².
TEST(SurfaceResponse, DielectricsHaveGlassUnderThem) {
    EXPECT_DOUBLE_EQ(dielectric_f0, (0.5 / 2.5) * (0.5 / 2.5));
}

}  // namespace
}  // namespace splitsum
