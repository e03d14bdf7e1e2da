#pragma once

#include "splitsum/brdf/lobe.h"
#include "splitsum/math/vec.h"

namespace splitsum {

/// Draws directions about +z from a lobe and knows how likely each of them is.
class LobeSampler {
public:
    /// `lobe.alpha` > 0.
    explicit LobeSampler(const Lobe& lobe);

    struct Sample {
        Vec3d direction;  ///< unit
        double versine;   ///< 1 - direction.z, with the digits that the subtraction would lose
    };

    /// Maps u in [0, 1)² to a direction above the horizon with density pdf. GGX: the half vectors
    /// of Walter et al. 2007, eq. 35, up to 45 degrees, beyond which reflections lie below the
    /// horizon; cosine: sin² theta = u.x.
    Sample sample(const Vec2d& u) const;

    /// Probability per steradian of a direction at this versine from the peak, 0 below the horizon:
    /// D / 4 (with n = v, v·h = n·h) over the share of half vectors within 45 degrees, which is
    /// 1 / (1 + alpha²); cosine: cos theta / pi.
    double pdf(double versine) const;

    /// The lobe divided by its exact integral over the sphere, per steradian.
    double value(double versine) const;

private:
    Lobe lobe_;
    double visible_ = 1;  // the share of half vectors within 45 degrees
    double inverse_integral_;
};

}  // namespace splitsum
