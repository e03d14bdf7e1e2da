#include "splitsum/ltc/shape.h"

#include <cmath>
#include <numbers>

namespace splitsum {
namespace {

// Products with (x, z) that turn them to an axis `angle` from +z towards +x.
Vec2d along_x(double angle) { return {std::cos(angle), -std::sin(angle)}; }
Vec2d along_z(double angle) { return {std::sin(angle), std::cos(angle)}; }

}  // namespace

LtcInverse inverse_of(const LtcShape& shape) {
    const double width_y = std::exp(shape.log_width_y);
    const Vec2d cut_z = along_z(shape.axis_angle + shape.tilt);
    const Vec2d row_x =
        std::exp(-shape.log_width_x) * along_x(shape.axis_angle) - shape.shear * cut_z;
    return {.m00 = width_y * row_x.x,
            .m20 = width_y * cut_z.x,
            .m02 = width_y * row_x.y,
            .m22 = width_y * cut_z.y};
}

LtcDifferentiator::LtcDifferentiator(const LtcShape& shape)
    : axis_x_(along_x(shape.axis_angle)),
      cut_z_(along_z(shape.axis_angle + shape.tilt)),
      cut_x_(along_x(shape.axis_angle + shape.tilt)),
      inverse_x_(std::exp(-shape.log_width_x)),
      inverse_y_(std::exp(-shape.log_width_y)),
      shear_(shape.shear),
      tan_tilt_(std::tan(shape.tilt)),
      factor_(std::exp(shape.log_magnitude) * std::cos(shape.tilt) * inverse_x_ * inverse_y_) {}

// density = z' magnitude determinant / (pi |w|^4), and the derivatives are those of its logarithm times the
// density, where the one that has z' in its denominator is taken apart.
LtcSlope LtcDifferentiator::operator()(const Vec3d& direction) const {
    const Vec2d flat(direction.x, direction.z);
    const double z = dot(cut_z_, flat);
    if (z <= 0) return {};
    const double scaled_x = dot(axis_x_, flat) * inverse_x_;
    const double w_x = scaled_x - shear_ * z;
    const double w_y = direction.y * inverse_y_;
    const double inverse2 = 1 / (w_x * w_x + w_y * w_y + z * z);
    const double density_over_z = factor_ * std::numbers::inv_pi * inverse2 * inverse2;
    const double density = z * density_over_z;
    const double z_by_tilt = dot(cut_x_, flat);
    return {density,
            {density_over_z * z_by_tilt - density * tan_tilt_ +
                 4 * density * inverse2 * z_by_tilt * (w_x * shear_ - z),
             density * (4 * w_x * scaled_x * inverse2 - 1),
             density * (4 * w_y * w_y * inverse2 - 1), 4 * density * w_x * z * inverse2, density}};
}

}  // namespace splitsum
