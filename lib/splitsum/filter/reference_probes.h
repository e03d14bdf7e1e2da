#pragma once

#include <span>
#include <vector>

#include "splitsum/brdf/lobe.h"
#include "splitsum/filter/row_quadrature.h"
#include "splitsum/math/vec.h"

namespace splitsum {

/// `reference` (reference.h) at directions that are known before the light is: rows are summed as
/// they pass by and need not be kept. The arithmetic is the same, and so are the bits.
///
/// Cost: for each probe that of `reference`, in parallel over probes.
class ReferenceProbes {
public:
    /// Which light a lobe sees towards a unit direction in panorama space. alpha > 0.
    struct Probe {
        Lobe lobe;
        Vec3d towards;
    };

    ReferenceProbes(int height, std::span<const Probe> probes);

    /// The next rows, from the top down. A texel is `floats_per_texel` floats (3 or 4) of which the
    /// first three are its radiance. The bits do not depend on how many rows come at a time.
    void add_rows(int row_count, const float* texels, int floats_per_texel);

    /// The radiance at each probe, when every row was added.
    std::vector<Vec3> finish() const;

private:
    struct Sum {
        Lobe lobe;
        RowQuadrature::Towards towards;
        Vec3d sum{0};
    };

    RowQuadrature rows_;
    std::vector<Sum> sums_;
    int next_row_ = 0;
};

}  // namespace splitsum
