#pragma once

#include <span>
#include <string>
#include <string_view>

#include "splitsum/base/result.h"
#include "splitsum/math/vec.h"

namespace splitsum {

/// How a tool whose output must be matched lays a panorama around the cube: the panorama's azimuth
/// is sign * cube azimuth + offset, where the azimuth of (x, y, z) is atan2(x, z) and the middle of
/// the panorama has azimuth 0.
struct Convention {
    std::string_view name;     ///< as typed after --convention
    std::string_view summary;  ///< one line for --help
    double sign;               ///< 1, or -1 where the image is mirrored
    double offset_degrees;
};

/// Every convention; the first is the default.
std::span<const Convention> conventions();

/// How a panorama is turned before and while it is laid around the cube.
struct Orientation {
    double rotate_degrees =
        0;                ///< turns the panorama: what was in its middle (+Z) moves towards +X
    bool mirror = false;  ///< swaps left and right of the panorama, before it is turned
    std::string convention = "ktx";
};

/// Fails with bad_argument for an unknown convention or a rotation that is not finite.
Status validate(const Orientation& orientation);

/// The matrix that takes a cube direction to the panorama direction seen there; panorama space is
/// the `ktx` convention without rotation or mirroring. Orthogonal; its determinant is -1 where the
/// result is mirrored. `orientation` must be valid.
Mat3d panorama_from_cube(const Orientation& orientation);

}  // namespace splitsum
