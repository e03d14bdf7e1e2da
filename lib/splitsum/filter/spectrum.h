#pragma once

#include <span>
#include <vector>

#include "splitsum/sphere/environment.h"

namespace splitsum {

/// An environment as spherical-harmonic coefficients about the panorama's pole (+y):
///     a_lm = ∫ L P_lm(cos theta) e^(-i m phi) dl,   m >= 0,
/// with orthonormal P_lm(cos theta) e^(i m phi) and the azimuth of sphere/environment.h. Negative m
/// are the complex conjugates, because radiance is real.
class Spectrum {
public:
    explicit Spectrum(int bands);

    int bands() const { return bands_; }  ///< l < bands

    /// The coefficients of order m, for l = m .. bands - 1 six numbers each: real parts of red,
    /// green, blue, then imaginary parts.
    std::span<double> order(int m);
    std::span<const double> order(int m) const;

    /// Power of band l: sum over m, positive and negative, and the three channels of |a_lm|².
    double power(int l) const { return power_[size_t(l)]; }
    /// ∫ L² dl over the three channels: the sum of the power of *all* bands, those left out too.
    double total_power() const { return total_power_; }

private:
    friend Spectrum forward_transform(const Environment& environment, int bands);
    void measure_power(double total_power);

    int bands_;
    std::vector<double> coefficients_;
    std::vector<double> power_;
    double total_power_ = 0;
};

/// The transform of the piecewise-constant environment: exact over each texel's azimuths (an FFT
/// along each row, then the closed form of a texel's Fourier transform), Gauss points over each
/// row's polar angles. `bands` may exceed the number of rows: a piecewise-constant function has
/// power there.
///
/// Error: about 1e-7 of the row's largest coefficients (the FFT is fp32, everything after it fp64),
/// and 1e-5 at the highest band for the Gauss points, much less below it.
/// Cost: rows * bands² / 4 steps of the Legendre recurrence for each Gauss point, in parallel over
/// orders. Memory: 6 floats a row and order, 24 bytes a coefficient.
Spectrum forward_transform(const Environment& environment, int bands);

/// ∫ L² dl over the sphere, the three channels together.
double integral_of_square(const Environment& environment);

}  // namespace splitsum
