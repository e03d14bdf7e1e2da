#pragma once

#include <cstddef>

#include "splitsum/base/buffer.h"

namespace splitsum {

/// A function of few bands on a grid fine enough that a polynomial between its points is as good
/// as the function: rings at polar angles pi (k + 1/2) / rings, points at azimuths
/// 2 pi j / columns - pi.
class SphereGrid {
public:
    /// How far around a point the interpolation reaches, on either side.
    static constexpr int reach = 3;

    /// The points have no values yet.
    SphereGrid(int rings, int columns);

    int rings() const { return rings_; }
    int columns() const { return columns_; }

    /// Ring k, four floats a point, the last of which is 0; k from -reach to rings + reach - 1, columns likewise: the grid
    /// goes on over the poles and around the circle.
    float* point(int ring, int column) {
        return points_.data() + 4 * (size_t(ring + reach) * stride() + size_t(column + reach));
    }
    const float* point(int ring, int column) const {
        return const_cast<SphereGrid*>(this)->point(ring, column);
    }

    /// Points from one ring to the next.
    size_t stride() const { return size_t(columns_ + 2 * reach); }

    /// Fills what lies beyond the poles and the seam from the grid itself.
    void continue_edges();

private:
    int rings_;
    int columns_;
    Buffer<float> points_;
};

}  // namespace splitsum
