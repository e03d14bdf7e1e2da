#pragma once

#include "splitsum/brdf/lobe.h"
#include "splitsum/filter/texel_quadrature.h"

namespace splitsum {

/// A GGX lobe too narrow for a transform, taken apart into a wide one and a rest:
///     K_alpha / ∫K_alpha = share * K_wide / ∫K_wide + rest,   share = (alpha / wide)².
/// Both tails fall off as alpha² / theta⁴, so with this share they cancel: the rest lives within a
/// few times sqrt(alpha * wide), and the sum over the texels there is short. The wide part is left
/// to the transform.
class NarrowLobe {
public:
    /// `alpha` < `wide_alpha`. What the rest holds beyond the cap is at most `accuracy` of the
    /// lobe's integral; the part inside is scaled so that a constant stays a constant.
    NarrowLobe(double alpha, double wide_alpha, double accuracy);

    /// The factor of what the transform gives for wide_alpha.
    double share() const { return share_; }

    /// What has to be added to that towards a unit direction.
    /// Cost: a few microseconds, and more for large panoramas.
    Vec3d rest(const TexelQuadrature& quadrature, const Vec3d& direction) const;

private:
    Lobe lobe_;
    Lobe wide_;
    double share_;
    double cap_radius_;
    double factor_;       // of the narrow lobe's integral over the cap
    double wide_factor_;  // of the wide one's
};

}  // namespace splitsum
