#include "splitsum/ltc/shape.h"

#include <gtest/gtest.h>

#include <cmath>

namespace splitsum {
namespace {

constexpr LtcShape lopsided = {.axis_angle = -0.8,
                               .tilt = 0.3,
                               .log_width_x = -0.7,
                               .log_width_y = -1.1,
                               .shear = 0.4,
                               .log_magnitude = 0.2};
const Vec3d directions[] = {normalize(Vec3d(-0.7, 0.2, 0.7)), normalize(Vec3d(-0.2, -0.4, 1)),
                            normalize(Vec3d(-1, 0.1, -0.2)), Vec3d(0, 0, 1)};

TEST(LtcShape, OfNothingIsTheClampedCosine) {
    const LtcInverse inverse = inverse_of({});
    EXPECT_EQ(inverse.m00, 1);
    EXPECT_EQ(inverse.m20, 0);
    EXPECT_EQ(inverse.m02, 0);
    EXPECT_EQ(inverse.m22, 1);
}

TEST(LtcShape, HasAPositiveDeterminantAtEveryTilt) {
    LtcShape shape = lopsided;
    for (shape.tilt = -1.5; shape.tilt <= 1.5; shape.tilt += 0.1)
        EXPECT_GT(determinant(inverse_of(shape)), 0) << shape.tilt;
}

double strength(const LtcShape& shape, const Vec3d& direction) {
    return std::exp(shape.log_magnitude) * ltc_density(inverse_of(shape), direction);
}

TEST(LtcDifferentiator, HasTheDensityAndItsSlopes) {
    constexpr double step = 1e-6;
    for (const Vec3d& direction : directions) {
        const LtcSlope slope = LtcDifferentiator(lopsided)(direction);
        const double density = strength(lopsided, direction);
        EXPECT_NEAR(slope.density, density, 1e-13);
        EXPECT_GT(density, 0);
        for (size_t i = 0; i < slope.by_parameter.size(); ++i) {
            const auto moved_by = [&](double amount) {
                auto values = lopsided.parameters();
                values[i] += amount;
                LtcShape shape = lopsided;
                shape.set_parameters(values);
                return strength(shape, direction);
            };
            EXPECT_NEAR(slope.by_parameter[i], (moved_by(step) - moved_by(-step)) / (2 * step),
                        1e-8)
                << "parameter " << i;
        }
    }
}

}  // namespace
}  // namespace splitsum
