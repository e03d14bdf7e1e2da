#pragma once

#include <string_view>
#include <vector>

#include "splitsum/math/vec.h"

namespace splitsum {

/// Lobes that a transformed cosine can be fitted to.
enum class LtcTarget {
    ggx,             ///< GGX with height-correlated Smith masking, without Fresnel
    disney_diffuse,  ///< Burley 2012
};

/// A direction with what quadrature needs: the integral of g over directions, of which the lobe is
/// not 0, is the sum of weight g(light).
struct LobeNode {
    Vec3d light;
    double weight;
};

/// A BRDF times n·l as a probability per steradian, seen from one view.
class TargetLobe {
public:
    /// The narrowest lobe: smoother surfaces are taken for this one (alpha = 2.5e-5), which no
    /// polygonal light tells from a mirror, and whose matrix still has an inverse in half floats.
    static constexpr double smoothest = 0.005;
    /// The most grazing view, for the same reason.
    static constexpr double most_grazing = 0.002;
    static constexpr int nodes_for_albedo = 48;

    /// `n_dot_v` and `perceptual_roughness` in [0, 1].
    TargetLobe(LtcTarget target, double n_dot_v, double perceptual_roughness);

    /// BRDF times n·l per steradian, 0 below the horizon. `light` is a unit vector in the frame of
    /// transformed_cosine.h.
    double value(const Vec3d& light) const;

    /// The same over its own integral, of which nodes_for_albedo² nodes() know three digits or more.
    double density(const Vec3d& light) const;

    /// Probability per steradian of the directions that follow the lobe: visible normals for GGX,
    /// a cosine for diffuse light; near to density, and 0 below the horizon.
    double sampling_pdf(const Vec3d& light) const;

    /// Gauss-Legendre nodes in the square that those directions are mapped from, `count` along each
    /// side, over the half y >= 0: twice the sum is the integral of an even function, to about 1e-3
    /// with 40 nodes a side (the horizon cuts through the square).
    std::vector<LobeNode> nodes(int count) const;

    /// GGX width, perceptual roughness squared and never 0.
    double alpha() const { return alpha_; }
    const Vec3d& view() const { return view_; }
    LtcTarget target() const { return target_; }

private:
    LtcTarget target_;
    double perceptual_roughness_;
    double alpha_;
    Vec3d view_;
    double albedo_ = 1;
};

}  // namespace splitsum
