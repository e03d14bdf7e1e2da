#pragma once

#include <optional>
#include <span>
#include <vector>

#include "splitsum/filter/line_fourier.h"
#include "splitsum/filter/rows_to_rings.h"
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
    friend class SpectrumBuilder;
    void measure_power(double total_power);

    int bands_;
    std::vector<double> coefficients_;
    std::vector<double> power_;
    double total_power_ = 0;
};

/// The transform of a piecewise-constant environment that arrives row by row, so that its texels
/// need not be kept: exact over each texel's azimuths (LineFourier), Gauss points over each row's
/// polar angles. `bands` may exceed the number of rows: a piecewise-constant function has power
/// there. With four and a half rows or more for each band, rows are first gathered on two to three
/// rings a band (RowsToRings), and the polynomial between rings takes the place of the Gauss points.
///
/// Error: about 1e-7 of the row's largest coefficients (the FFT is fp32, everything after it fp64),
/// and 3e-5 at the highest band for the Gauss points, or 2e-3 to 2e-2 at the highest and 6e-6 to 6e-5 at
/// half of it between rings: those are bands that the lobes have all but extinguished.
/// Cost: lines * bands² / 4 steps of the Legendre recurrence for each Gauss point, in parallel over
/// orders. Memory: 6 floats a line and band, then 24 bytes a coefficient.
class SpectrumBuilder {
public:
    SpectrumBuilder(int height, int bands);

    /// Adds the next rows from the top down, in parallel. A texel is `floats_per_texel` floats of
    /// which the first three are its radiance and a fourth is 0; the same number in every call. The
    /// bits do not depend on how many rows come at a time, as long as that is an even number.
    void add_rows(int row_count, const float* texels, int floats_per_texel);

    /// The spectrum, when every row was added.
    Spectrum finish() const;

private:
    int height_;
    int bands_;
    int next_row_ = 0;
    int lines_;                         // rings, or rows
    std::optional<RowsToRings> rings_;  // where there are many rows
    LineFourier fourier_;
    std::vector<double> row_power_;  // ∫ L² over each row
};

/// SpectrumBuilder over the rows of an environment.
Spectrum forward_transform(const Environment& environment, int bands);

/// ∫ L² dl over the sphere, the three channels together.
double integral_of_square(const Environment& environment);

}  // namespace splitsum
