#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace splitsum {

// The sums over associated Legendre functions that are nearly the whole cost of a spherical-harmonic
// transform. One order m is one independent piece of work; the degree l runs upwards, the stable
// direction of the recurrence (Holmes & Featherstone 2002, J. Geodesy 76, eq. 11)
//     P_l = a_l (x P_(l-1) - b_l P_(l-2)),   a_l = sqrt((4 l² - 1) / (l² - m²)),  b_l = 1 / a_(l-1).
// P is normalised so that P_lm(cos theta) e^(i m phi) is orthonormal over the sphere.
//
// Everything is fp64: in fp32 the recurrence loses 1e-4 by l = 500. SIMD lanes (Highway, dispatched
// at run time) run over polar angles, which are stored in columns padded to a multiple of
// `theta_padding`.

inline constexpr size_t theta_padding = 8;

/// `count` rounded up to a multiple of theta_padding.
inline size_t padded(size_t count) {
    return (count + theta_padding - 1) / theta_padding * theta_padding;
}

/// What P_mm(theta) starts from, and the recurrence's coefficients, for one order m.
struct LegendreOrder {
    int m = 0;
    double start = 0;       ///< P_mm / sin^m theta
    std::vector<double> a;  ///< a_l for l = m .. bands - 1 (the first is not used)
    std::vector<double> b;  ///< b_l, likewise

    LegendreOrder(int order, int bands);
};

/// The first of `sines` (ascending, of polar angles from the pole) at which some P_lm with l < bands
/// is above about 1e-9 of its largest value, rounded down to a multiple of theta_padding: nearer to
/// the pole, where (l + 1/2) sin theta < m, the functions die off like Airy's.
size_t first_relevant_angle(int m, int bands, std::span<const double> sines);

/// Three channels of a complex number, one after the other: real parts, then imaginary parts.
inline constexpr size_t complex_rgb = 6;

/// Rows of an environment and, for each, Gauss points in the polar angle. Lanes hold rows of the
/// northern half.
struct LegendreRows {
    size_t rows = 0;    ///< padded
    size_t points = 0;  ///< Gauss points a row
    /// [point][row]: cosine and sine of the polar angle, and weight * sin(theta) (0 in padding).
    std::vector<double> cosine, sine, weight;
};

/// Integrates one order over the rows: for every l in [m, bands),
///     out[(l - m) * complex_rgb + c] = sum over rows of F_c(row) * ∫_row P_lm sin dtheta,
/// where F is `even` where l + m is even (the sum of a northern row and its southern mirror) and
/// `odd` where it is odd (their difference). `even` and `odd` are [complex_rgb][rows] floats. Rows
/// below `first_row` (a multiple of theta_padding) are left out.
void integrate_order(const LegendreOrder& order, int bands, const LegendreRows& rows,
                     size_t first_row, const float* even, const float* odd, double* out);

/// Sums one order at polar angles: for angle j in [first, cosine.size()),
///     even[c][j] = sum over l, l + m even, of coefficients[(l - m) * complex_rgb + c] * P_lm,
/// and `odd` likewise. The northern value is even + odd, its southern mirror even - odd.
/// `cosine`, `sine` are padded; `even`, `odd` are [complex_rgb][cosine.size()] floats.
void sum_order(const LegendreOrder& order, int bands, std::span<const double> cosine,
               std::span<const double> sine, size_t first, const double* coefficients, float* even,
               float* odd);

}  // namespace splitsum
