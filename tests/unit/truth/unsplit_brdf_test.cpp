#include "splitsum/truth/unsplit_brdf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "splitsum/brdf/visible_normals.h"
#include "splitsum/math/quadrature.h"
#include "surfaces.h"

namespace splitsum {
namespace {

constexpr double pi = std::numbers::pi;

UnsplitBrdf brdf_of(const Surface& surface) {
    return UnsplitBrdf(surface.alpha, surface.view, surface.response);
}

// The integral of f(light) over the hemisphere, in panels small enough for lobes of alpha > 0.1.
template <class Value, class Function>
Value over_hemisphere(const Function& f) {
    const QuadratureRule rule = gauss_legendre(8);
    constexpr int rows = 64, columns = 128;
    Value sum{0};
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            for (int i = 0; i < 8; ++i)
                for (int j = 0; j < 8; ++j) {
                    const double theta = (row + 0.5 + 0.5 * rule.nodes[size_t(i)]) * pi / 2 / rows;
                    const double phi =
                        (column + 0.5 + 0.5 * rule.nodes[size_t(j)]) * 2 * pi / columns;
                    const Vec3d light(std::sin(theta) * std::cos(phi),
                                      std::sin(theta) * std::sin(phi), std::cos(theta));
                    const double weight = rule.weights[size_t(i)] * rule.weights[size_t(j)] / 4 *
                                          (pi / 2 / rows) * (2 * pi / columns);
                    sum += weight * std::sin(theta) * f(light);
                }
    return sum;
}

// What compensation and diffuse albedo are for: the split sum is exact under uniform light.
TEST(UnsplitBrdf, IntegratesToWhatTheSurfaceReflectsOfUniformLight) {
    for (const double metalness : {0.0, 0.3, 1.0})
        for (const double perceptual_roughness : {0.0, 0.35, 1.0})
            for (const double n_dot_v : {0.15, 0.7}) {
                const Surface surface = tests::lopsided_surface(
                    {Vec3d(1, 0.6, 0.2), metalness, perceptual_roughness}, n_dot_v);
                const UnsplitBrdf brdf = brdf_of(surface);
                const auto f = [&](const Vec3d& light) { return brdf.towards(light).reflected; };
                const Vec3d found = over_hemisphere<Vec3d>(f);
                Vec3d expected = surface.response.diffuse_albedo;
                if (surface.alpha > 0) expected += surface.response.reflectance;
                EXPECT_LT(length(found - expected), 2e-6)
                    << metalness << ' ' << perceptual_roughness << ' ' << n_dot_v;
            }
}

TEST(UnsplitBrdf, ReflectsNothingFromBelow) {
    const UnsplitBrdf brdf = brdf_of(tests::lopsided_surface({}, 0.3));
    const auto value = brdf.towards(normalize(Vec3d(0.4, 0.2, -1e-6)));
    EXPECT_EQ(value.reflected, Vec3d(0));
    EXPECT_EQ(value.lobe_pdf, 0);
    EXPECT_EQ(value.cosine_pdf, 0);
}

TEST(UnsplitBrdf, KnowsTheDensityOfReflectionsAtVisibleNormals) {
    const Surface surface = tests::lopsided_surface({Vec3d(1), 1, 0.6}, 0.25);
    const UnsplitBrdf brdf = brdf_of(surface);
    for (const Vec3d& toward : {Vec3d(0.1, 0.2, 1), Vec3d(-0.5, 0.5, 0.1), Vec3d(1, 0, 0.5)}) {
        const Vec3d light = normalize(toward), half = normalize(light + surface.view);
        const double expected =
            visible_normal_pdf(surface.view, half, surface.alpha) / (4 * dot(surface.view, half));
        EXPECT_NEAR(brdf.towards(light).lobe_pdf / expected, 1, 1e-12);
        EXPECT_EQ(brdf.towards(light).cosine_pdf, 0);  // of metals
    }
}

TEST(UnsplitBrdf, IsFiniteAtGrazingViews) {
    for (const double perceptual_roughness : {1e-3, 0.1, 1.0}) {
        const UnsplitBrdf brdf =
            brdf_of(tests::lopsided_surface({Vec3d(1), 0.5, perceptual_roughness}, 0));
        for (const double z : {1e-9, 0.01, 1.0}) {
            const auto value = brdf.towards(normalize(Vec3d(-1, 0.1, z)));
            EXPECT_TRUE(std::isfinite(value.reflected.x) && std::isfinite(value.lobe_pdf));
        }
    }
}

}  // namespace
}  // namespace splitsum
