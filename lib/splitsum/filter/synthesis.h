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

/// The first factors.size() bands of the spectrum, band l multiplied by factors[l], on a grid of at
/// least twice as many rings as bands and four times as many columns: half the spacing at which the
/// highest band could just be told.
/// Cost: rings * bands² / 4 steps of the Legendre recurrence, parallel over orders, and an FFT a
/// ring. Error: fp32 rounding.
SphereGrid synthesize(const Spectrum& spectrum, std::span<const double> factors);

/// The grid's function towards a unit direction, by Lagrange's polynomial through 6 x 6 points. The
/// error grows with the sixth power of frequency times spacing: 7e-2 of a component at the highest
/// band of synthesize, 1e-3 at half of it, 2e-5 at a quarter (tested), and lobes leave little of
/// the highest.
Vec3 interpolate(const SphereGrid& grid, const Vec3d& direction);

}  // namespace splitsum
