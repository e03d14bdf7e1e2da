#pragma once

#include <span>

#include "splitsum/filter/spectrum.h"
#include "splitsum/filter/sphere_grid.h"

namespace splitsum {

/// How many rings a grid needs.
struct GridSize {
    int rings = 0;
    double interpolation_bound = 0;  ///< relative error (rel_rms over the sphere)
};

/// The fewest rings for which interpolating the filtered spectrum (its first factors.size() bands)
/// costs at most `accuracy`: band l, of l pi / rings radians from one point to the next, is missed by
/// no more than the interpolation_error of that angle. At least one ring a band, so that nothing
/// folds over; at most eight.
GridSize grid_size(const Spectrum& spectrum, std::span<const double> factors, double accuracy);

/// The first factors.size() bands of the spectrum, band l multiplied by factors[l], on a grid of
/// that many rings (even) and at least twice as many columns.
/// Cost: rings * bands² / 4 steps of the Legendre recurrence, parallel over orders, and an FFT a
/// ring. Error: fp32 rounding.
SphereGrid synthesize(const Spectrum& spectrum, std::span<const double> factors, int rings);

}  // namespace splitsum
