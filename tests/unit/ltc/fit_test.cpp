#include "splitsum/ltc/fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "splitsum/ltc/lobe_difference.h"
#include "splitsum/ltc/ltc_table.h"

namespace splitsum {
namespace {

LtcInverse fitted(LtcTarget target, double n_dot_v, double perceptual_roughness) {
    NoProgress progress;
    const auto table = fit_ltc_table(target, {&n_dot_v, 1}, {&perceptual_roughness, 1}, progress);
    return table->front().inverse;
}

// Near a mirror the lobe is the distribution of facets itself, which in slopes is
// 1 / (1 + |slope|²)², a clamped cosine seen in its plane: with widths 2 alpha in the plane of
// reflection and 2 alpha n·v across it. So the limit is not fitted but known,
//     M^-1 = diag(n·v, 1, 2 alpha n·v) R,   R turning the mirror direction to +z.
TEST(FitLtc, FindsTheExactLimitOfNarrowLobes) {
    const double r = 0.03;
    for (const double c : {0.3, 0.6, 0.95}) {
        const double s = std::sqrt(1 - c * c), width = 2 * r * r * c;
        const LtcInverse inverse = fitted(LtcTarget::ggx, c, r);
        EXPECT_NEAR(inverse.m00, c * c, 1e-3) << c;
        EXPECT_NEAR(inverse.m02, c * s, 1e-3) << c;
        EXPECT_NEAR(inverse.m20 / width, -s, 0.02) << c;
        EXPECT_NEAR(inverse.m22 / width, c, 0.02) << c;
    }
}

// The nodes in azimuth and in slope are not the same, so quadrature sees 2e-5 of anisotropy.
TEST(FitLtc, IsIsotropicAlongTheNormal) {
    for (const LtcTarget target : {LtcTarget::ggx, LtcTarget::disney_diffuse}) {
        const LtcInverse inverse = fitted(target, 1, 0.7);
        EXPECT_NEAR(inverse.m00, 1, 1e-4);
        EXPECT_NEAR(inverse.m20, 0, 1e-5);
        EXPECT_NEAR(inverse.m02, 0, 1e-5);
    }
}

// What a descent must not depend on. With nodes too few for the horizon that cuts through them, where
// they are placed shows: 1e-3 with 16.
TEST(FitLtc, EndsWhereItEndsFromElsewhere) {
    const TargetLobe lobe(LtcTarget::ggx, 0.4, 0.5);
    const LtcShape near = {.axis_angle = -0.9, .log_width_x = -0.8, .log_width_y = -0.9};
    const LtcShape far = {.axis_angle = -0.9, .log_width_x = -0.2, .log_width_y = 0.1};
    const LtcFitPlan plan{.nodes = 32, .rounds = 6, .steps = 40};
    const LtcInverse a = inverse_of(fit_ltc(lobe, near, plan));
    const LtcInverse b = inverse_of(fit_ltc(lobe, far, plan));
    EXPECT_NEAR(a.m00, b.m00, 1e-4);
    EXPECT_NEAR(a.m20, b.m20, 1e-4);
    EXPECT_NEAR(a.m02, b.m02, 1e-4);
    EXPECT_NEAR(a.m22, b.m22, 1e-4);
}

TEST(LobeDifference, ModelIsItsValueAndSlope) {
    const TargetLobe lobe(LtcTarget::ggx, 0.4, 0.5);
    const LtcShape around = {.axis_angle = -0.9, .log_width_x = -0.7, .log_width_y = -0.8};
    const LobeDifference difference(lobe, around, {});
    const LtcShape shape = {.axis_angle = -0.9,
                            .tilt = 0.1,
                            .log_width_x = -0.6,
                            .log_width_y = -0.9,
                            .shear = 0.05,
                            .log_magnitude = -0.03};
    const LobeDifference::Model model = difference.model(shape);
    EXPECT_NEAR(model.value, difference.value(shape), 1e-12);
    constexpr double step = 1e-5;
    for (size_t i = 0; i < model.gradient.size(); ++i) {
        const auto moved_by = [&](double amount) {
            auto values = shape.parameters();
            values[i] += amount;
            LtcShape moved = shape;
            moved.set_parameters(values);
            return difference.value(moved);
        };
        EXPECT_NEAR(2 * model.gradient[i], (moved_by(step) - moved_by(-step)) / (2 * step),
                    1e-5 * std::sqrt(model.value))
            << "parameter " << i;
    }
}

// With the weights of one set of directions missing, an exact lobe would not come out as 0.
TEST(LobeDifference, GrowsWithTheDifference) {
    const TargetLobe lobe(LtcTarget::disney_diffuse, 0.9, 0.5);
    const LobeDifference difference(lobe, {}, {});
    double before = difference.value({});
    EXPECT_LT(before, 2e-3);
    for (const double tilt : {0.2, 0.4, 0.6}) {
        const double now = difference.value({.axis_angle = tilt});
        EXPECT_GT(now, before);
        before = now;
    }
}

}  // namespace
}  // namespace splitsum
