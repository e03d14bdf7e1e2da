#pragma once

#include <span>
#include <vector>

#include "splitsum/filter/spectrum.h"
#include "splitsum/math/vec.h"

namespace splitsum {

/// A function of few bands on a grid fine enough that a polynomial between its points is as good
/// as the function: rings at polar angles pi (k + 1/2) / rings, points at azimuths
/// 2 pi j / columns - pi.
class SphereGrid {
public:
    /// How far around a point the interpolation reaches, on either side.
    static constexpr int reach = 3;

    SphereGrid(int rings, int columns);

    int rings() const { return rings_; }
    int columns() const { return columns_; }

    /// Ring k, four floats a point; k from -reach to rings + reach - 1, columns likewise: the grid
    /// goes on over the poles and around the circle.
    float* point(int ring, int column) {
        return points_.data() + 4 * (size_t(ring + reach) * stride() + size_t(column + reach));
    }
    const float* point(int ring, int column) const {
        return const_cast<SphereGrid*>(this)->point(ring, column);
    }

    /// Fills what lies beyond the poles and the seam from the grid itself.
    void continue_edges();

private:
    size_t stride() const { return size_t(columns_ + 2 * reach); }

    int rings_;
    int columns_;
    std::vector<float> points_;
};

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

/// The largest error of `interpolate` for a wave that turns by `angle` radians from point to point:
/// Lagrange's remainder with six points, 4.9e-3 angle⁶.
double interpolation_error(double angle);

/// The first factors.size() bands of the spectrum, band l multiplied by factors[l], on a grid of
/// that many rings (even) and at least twice as many columns.
/// Cost: rings * bands² / 4 steps of the Legendre recurrence, parallel over orders, and an FFT a
/// ring. Error: fp32 rounding.
SphereGrid synthesize(const Spectrum& spectrum, std::span<const double> factors, int rings);

/// The grid's function towards a unit direction, by Lagrange's polynomial through 6 x 6 points.
Vec3 interpolate(const SphereGrid& grid, const Vec3d& direction);

}  // namespace splitsum
