#pragma once

#include <array>

#include "splitsum/ltc/transformed_cosine.h"

namespace splitsum {

/// A transformed cosine as a fit moves it. With x and z turned to an axis in the plane of view and
/// normal, and z' turned by `tilt` more, a direction in cosine space is
///
///     (x / exp(log_width_x) - shear z',  y / exp(log_width_y),  z')
///
/// The widths and the shear move the lobe's body; the tilt turns the plane z' = 0 that cuts it off,
/// and leaves the body of a narrow lobe where it is. Equal steps move narrow and wide lobes alike,
/// and every shape with |tilt| < pi / 2 has a positive determinant. Heitz et al. 2016 fit the first
/// three, with the axis at the mean direction; turning the cut-off as well nearly halves the error
/// of polygons shaded by an otherwise equal fit. The magnitude is what all of the lobe integrates to,
/// and no part of the matrix.
struct LtcShape {
    static constexpr int parameter_count = 5;

    double axis_angle = 0;  ///< radians from +z towards +x, held fixed by a fit
    double tilt = 0;        ///< radians
    double log_width_x = 0;
    double log_width_y = 0;
    double shear = 0;
    double log_magnitude = 0;

    std::array<double, parameter_count> parameters() const {
        return {tilt, log_width_x, log_width_y, shear, log_magnitude};
    }
    void set_parameters(const std::array<double, parameter_count>& values) {
        tilt = values[0];
        log_width_x = values[1];
        log_width_y = values[2];
        shear = values[3];
        log_magnitude = values[4];
    }
};

LtcInverse inverse_of(const LtcShape& shape);

/// The magnitude times ltc_density, and its derivatives by the parameters of a shape, in the order of
/// parameters().
struct LtcSlope {
    double density = 0;
    std::array<double, LtcShape::parameter_count> by_parameter{};
};

/// Prepared for many directions.
class LtcDifferentiator {
public:
    explicit LtcDifferentiator(const LtcShape& shape);
    LtcSlope operator()(const Vec3d& direction) const;

private:
    Vec2d axis_x_;  ///< x along the axis is the product with a direction's (x, z); so is
    Vec2d cut_z_;   ///< z', and
    Vec2d cut_x_;   ///< its derivative by the tilt
    double inverse_x_, inverse_y_, shear_, tan_tilt_;
    double factor_;  ///< magnitude times determinant
};

}  // namespace splitsum
