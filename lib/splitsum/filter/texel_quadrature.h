#pragma once

#include "splitsum/brdf/lobe.h"
#include "splitsum/filter/row_quadrature.h"
#include "splitsum/sphere/environment.h"

namespace splitsum {

/// Integrals of lobe times environment over the environment's texels in fp64: RowQuadrature, summed
/// from the top row down.
class TexelQuadrature {
public:
    /// `environment` must outlive the object; `near_texels` as of RowQuadrature.
    TexelQuadrature(const Environment& environment, double near_texels);

    /// ∫ L K dl over the hemisphere around a unit direction, not divided by the lobe's integral.
    /// Cost: half the texels times four evaluations of the lobe, about 1 ms for 1024 x 512 on one
    /// core.
    Vec3d over_hemisphere(const Lobe& lobe, const Vec3d& direction) const;

    /// The same over the texels within `radius` radians (below pi / 2), about as many.
    Vec3d over_cap(const Lobe& lobe, const Vec3d& direction, double radius) const;

private:
    TexelRow row(int y) const;

    const Environment& environment_;
    RowQuadrature rows_;
};

}  // namespace splitsum
