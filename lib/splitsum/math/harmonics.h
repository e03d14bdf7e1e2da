#pragma once

#include <cstddef>
#include <span>

#include "splitsum/math/vec.h"

namespace splitsum {

/// Real spherical harmonics, orthonormal over the sphere, about the pole +z, in the convention of
/// Ramamoorthi & Hanrahan 2001 and Sloan 2008: no Condon-Shortley phase, so that
///     Y_00 = 1 / sqrt(4 pi),   (Y_1-1, Y_10, Y_11) = sqrt(3 / (4 pi)) (y, z, x).
/// Coefficients of all bands 0 .. order lie one after the other.

/// How many harmonics the bands 0 .. order have.
inline size_t harmonic_count(int order) {
    return static_cast<size_t>(order + 1) * static_cast<size_t>(order + 1);
}

/// Where band l, -l <= m <= l, lies among the coefficients.
inline size_t harmonic_index(int l, int m) { return static_cast<size_t>(l * l + l + m); }

/// Writes Y_lm(direction) to values[harmonic_index(l, m)] for every l <= order. `direction` is a
/// unit vector, the poles included; `values` holds at least harmonic_count(order) numbers.
///
/// fp64 recurrence over l at fixed m, the stable direction (Holmes & Featherstone 2002, J. Geodesy
/// 76, eq. 11); absolute error below 1e-12 up to order 200 (tested by the addition theorem). Above
/// order 1900 the start values of the recurrence underflow where they still count. Cost: O(order²).
void evaluate_harmonics(const Vec3d& direction, int order, std::span<double> values);

}  // namespace splitsum
