#pragma once

#include "splitsum/math/vec.h"
#include "splitsum/shading/surface.h"

namespace splitsum {

/// What a surface does with light from one direction, at one view: what the split sum approximates,
/// before anything is split.
///
///     f = C D V F(v·h) + A / pi:   GGX, height-correlated Smith, Schlick's Fresnel,
///
/// where compensation C and diffuse albedo A are response_of() the exact split sum at this view. So
/// f n·l integrates to reflectance + diffuse_albedo exactly, and under uniform light the split sum
/// and this are the same. Directions are unit vectors in the surface's frame, +z its normal.
class UnsplitBrdf {
public:
    /// Of a surface of this `alpha`, in (0, 1], or 0: then the reflection is a perfect mirror's,
    /// which no direction but one has a share in, and only f = A / pi is left here. `view`.z is in
    /// [0, 1].
    UnsplitBrdf(double alpha, const Vec3d& view, const SurfaceResponse& response);

    /// f n·l towards a direction, and how likely each way of sampling is to choose it, per
    /// steradian.
    struct Value {
        Vec3d reflected{0};
        double lobe_pdf = 0;    ///< of reflections at visible normals
        double cosine_pdf = 0;  ///< of cosine_direction_pdf; 0 of metals: nothing to draw for
    };

    /// Nothing below the horizon. `half` is the unit vector half way between the view and `light`:
    /// the digits of its x and y are those of the result.
    Value towards(const Vec3d& light, const Vec3d& half) const;
    Value towards(const Vec3d& light) const { return towards(light, normalize(light + view_)); }

    double alpha() const { return alpha_; }
    const Vec3d& view() const { return view_; }

    /// False of metals.
    bool is_diffuse() const { return diffuse_ != Vec3d(0); }

private:
    double alpha_;
    Vec3d view_;
    Vec3d f0_;
    Vec3d compensation_;
    Vec3d diffuse_;      // A / pi
    double seen_share_;  // G1(v) / (4 n·v)
};

}  // namespace splitsum
