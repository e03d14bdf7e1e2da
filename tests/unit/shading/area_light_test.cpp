#include "splitsum/shading/area_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace splitsum {
namespace {

const Vec3d normal = normalize(Vec3d(0.3, 0.8, -0.4));
const Vec3d view = normalize(Vec3d(0.9, 0.5, 0.2));
// A lobe that leans away from the viewer.
constexpr LtcInverse leaning{.m00 = 2.5, .m20 = -0.3, .m02 = 0.9, .m22 = 1.1};

// Four corners around `centre`, whose lit side is the one that looks at the origin.
LightCorners light_around(const Vec3d& centre, double width) {
    const Basis frame = basis_around(-normalize(centre));
    const auto corner = [&](double x, double y) {
        return centre + width * (x * frame.tangent + y * frame.bitangent);
    };
    return {corner(-1, -1), corner(1, -1), corner(1, 1.5), corner(-1, 1.5)};
}

TEST(LightFrame, HasTheNormalUpAndTheViewerInFront) {
    const Mat3d frame = light_frame(normal, view);
    EXPECT_LT(length(frame * normal - Vec3d(0, 0, 1)), 1e-12);
    const Vec3d seen = frame * view;
    EXPECT_NEAR(seen.y, 0, 1e-12);
    EXPECT_GT(seen.x, 0);
    EXPECT_NEAR(seen.z, dot(normal, view), 1e-12);
    const Vec3d a(1, 2, 3), b(-2, 0.5, 1);
    EXPECT_LT(length(cross(frame * a, frame * b) - frame * cross(a, b)), 1e-12) << "a rotation";
}

TEST(LightFrame, ExistsForViewersAlongTheNormal) {
    for (const Vec3d& n : {normal, Vec3d(0, 0, 1), Vec3d(0, 0, -1), Vec3d(0, 1, 0)}) {
        const Mat3d frame = light_frame(n, n);
        EXPECT_LT(length(frame * n - Vec3d(0, 0, 1)), 1e-12);
        EXPECT_NEAR(length(frame * Vec3d(1, 2, 3)), std::sqrt(14.0), 1e-12);
    }
}

TEST(AreaLight, OfOneSideIsDarkFromBehind) {
    const Mat3d frame = light_frame(normal, view);
    const LightCorners front = light_around(2.0 * normal, 0.5);
    LightCorners back = front;
    std::ranges::reverse(back);
    const double seen = area_light(leaning, frame, front, false);
    EXPECT_GT(seen, 0.05);
    EXPECT_EQ(area_light(leaning, frame, back, false), 0);
    EXPECT_NEAR(area_light(leaning, frame, back, true), seen, 1e-12);
}

TEST(AreaLight, BelowTheSurfaceIsNothing) {
    const Mat3d frame = light_frame(normal, view);
    EXPECT_EQ(area_light({}, frame, light_around(-2.0 * normal, 0.5), true), 0);
}

// A light that fills the sky is all that a lobe can gather.
TEST(AreaLight, ThatFillsTheSkyIsOne) {
    const Mat3d frame = light_frame(normal, view);
    const LightCorners sky = light_around(0.001 * normal, 1000);
    EXPECT_NEAR(area_light({}, frame, sky, false), 1, 1e-5);
}

// Small lights: the density of the lobe times the solid angle.
TEST(AreaLight, IsTheLobeTimesTheSolidAngle) {
    const Mat3d frame = light_frame(normal, view);
    for (const Vec3d& towards : {Vec3d(0.2, 1, 0), Vec3d(-0.3, 0.4, -0.7), Vec3d(0.4, 0.3, -1)}) {
        const Vec3d centre = 2.0 * normalize(towards);
        const LightCorners corners = light_around(centre, 0.001);
        Vec3d middle(0);
        for (const Vec3d& corner : corners) middle += 0.25 * corner;
        const double area = length(cross(corners[1] - corners[0], corners[3] - corners[0]));
        const double solid_angle = area / dot(middle, middle);
        const double density = ltc_density(leaning, normalize(frame * middle));
        EXPECT_GT(density, 0.01);
        EXPECT_NEAR(area_light(leaning, frame, corners, false) / (density * solid_angle), 1, 1e-3);
    }
}

TEST(AreaLight, TakesATriangleWithACornerTwice) {
    const Mat3d frame = light_frame(normal, view);
    const LightCorners quad = light_around(2.0 * normal, 0.5);
    const LightCorners one = {quad[0], quad[1], quad[2], quad[2]};
    const LightCorners other = {quad[0], quad[2], quad[3], quad[3]};
    EXPECT_NEAR(area_light(leaning, frame, one, false) + area_light(leaning, frame, other, false),
                area_light(leaning, frame, quad, false), 1e-12);
}

}  // namespace
}  // namespace splitsum
