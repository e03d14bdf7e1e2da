// Irradiance of a polygonal light has a closed form (Lambert 1760; Arvo 1995, "Applications of
// Irradiance Tensors", eq. 2): E = 1/2 sum of the angles of the edges times the cosine between the
// normal and each edge's plane. No code of this project takes part in it.

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "splitsum/filter/methods.h"
#include "support/lopsided_sky.h"

namespace splitsum {
namespace {

using Polygon = std::vector<Vec3d>;

// Corners, counter-clockwise as seen from the origin looking out.
double lambert_irradiance(const Polygon& light, const Vec3d& normal) {
    double sum = 0;
    for (size_t i = 0; i < light.size(); ++i) {
        const Vec3d a = normalize(light[i]), b = normalize(light[(i + 1) % light.size()]);
        sum += std::acos(dot(a, b)) * dot(normal, normalize(cross(a, b)));
    }
    return std::abs(0.5 * sum);
}

bool inside(const Polygon& light, const Vec3d& d) {
    const double side = dot(cross(light[0], light[1]), light[2]);
    for (size_t i = 0; i < light.size(); ++i)
        if (dot(cross(light[i], light[(i + 1) % light.size()]), d) * side <= 0) return false;
    return true;
}

// The share of each texel that the light covers, from 16 x 16 points.
Environment lit_by(const Polygon& light, int height) {
    constexpr int points = 16;
    Environment environment(height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < environment.width(); ++x) {
            int hits = 0;
            for (int j = 0; j < points; ++j)
                for (int i = 0; i < points; ++i)
                    hits += inside(
                        light, direction_of_lat_long((x + (i + 0.5) / points) / environment.width(),
                                                     (y + (j + 0.5) / points) / height));
            environment.set_texel(x, y, Vec3(float(hits) / (points * points)));
        }
    return environment;
}

TEST(PolygonLight, IrradianceIsLambertsFormula) {
    const Polygon lights[] = {{{1, 0.2, 0.3}, {1, 0.9, 0.1}, {0.8, 0.7, 0.9}},
                              {{-0.3, 1, -0.2}, {0.4, 1, -0.3}, {0.5, 1, 0.4}, {-0.2, 1, 0.3}}};
    const Vec3d normals[] = {normalize(Vec3d(0.9, 0.8, 0.5)), normalize(Vec3d(0.2, 1, 0.1)),
                             normalize(Vec3d(0.6, 0.7, -0.1))};
    const Lobe cosine{LobeKind::cosine};
    for (const Polygon& light : lights) {
        const Environment environment = lit_by(light, 256);
        for (const FilterMethod& method : filter_methods()) {
            if (!method.filters_cosine) continue;
            FilterPlan plan;
            plan.samples = 65536;
            const auto filter = method.prepare(environment, {&cosine, 1}, plan);
            std::vector<Vec3> over_pi(std::size(normals));
            filter->evaluate(0, {normals}, over_pi);
            // 160 texels of outline, each known to 1/256 of its area, among 2000 lit ones: 2e-4 was
            // measured. Samples read whole texels or blur them.
            const double tolerance = method.name == "reference" ? 4e-4 : 5e-3;
            for (size_t i = 0; i < std::size(normals); ++i) {
                const double expected = lambert_irradiance(light, normals[i]);
                EXPECT_NEAR(over_pi[i].x * std::numbers::pi, expected, tolerance * expected)
                    << method.name << " normal " << i;
            }
        }
    }
}

}  // namespace
}  // namespace splitsum
