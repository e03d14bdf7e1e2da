#pragma once

#include "splitsum/math/vec.h"
#include "splitsum/shading/material.h"
#include "splitsum/shading/surface.h"
#include "splitsum/truth/view_split_sum.h"

namespace splitsum {

/// The width of a material's lobe, 0 where it is narrower than 1e-7 radians, a four thousandth of a
/// texel of a 16K panorama: such a surface is a perfect mirror.
double alpha_of(const Material& material);

/// A point of a surface as a viewer sees it.
struct Surface {
    double alpha;              ///< 0 is a perfect mirror
    Basis frame;               ///< about the normal
    Vec3d view;                ///< towards the viewer, in that frame; z in [0, 1]
    SurfaceResponse response;  ///< by the exact split sum
};

/// `split_sum` is of alpha_of(material). `normal` and `view` are unit vectors; a view from behind
/// counts as a grazing one.
Surface surface_of(const Material& material, const ViewSplitSum& split_sum, const Vec3d& normal,
                   const Vec3d& view);

/// The direction that a mirror at this point shows, in the space of its normal.
Vec3d mirrored_view(const Surface& surface);

}  // namespace splitsum
