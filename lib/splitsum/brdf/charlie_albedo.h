#pragma once

#include <vector>

#include "splitsum/brdf/charlie.h"
#include "splitsum/math/tanh_sinh.h"

namespace splitsum {

/// Smoother cloth is taken for this: below it the lobe is a line along the horizon, and its albedo
/// at n·v = 0 grows without bound (as 0.4 / sqrt(alpha) for Neubelt's term).
inline constexpr double narrowest_cloth_alpha = 1e-4;
/// More grazing views are taken for this one.
inline constexpr double most_grazing_cloth_view = 1e-4;

/// The directional albedo ∫ D V n·l dl of cloth seen from one direction, for every width.
///
/// Integrated over half vectors, dl = 4 v·h dh: the angle theta_h first from the greatest that any
/// light above the horizon gives, then the azimuth from the one at which light sinks below it. Both
/// are ends at which a double-exponential rule crowds its nodes, whatever the width of
/// sin(theta)^(1 / alpha) there. The step is halved until the albedo of narrow and wide cloth stays
/// well within `tolerance`. Measured against charlie_albedo_exact: 2e-7 for Neubelt's terms, 2e-6 for the fit.
///
/// Neubelt's terms do not know the width: one pass over the azimuths serves every width, about
/// 0.3 ms a view and 1 µs an albedo. The fit of Estevez & Kulla costs about 0.2 ms an albedo.
class ClothAlbedo {
public:
    /// `n_dot_v` in [0, 1].
    ClothAlbedo(ClothVisibility visibility, double n_dot_v, double tolerance = 1e-6);

    /// `alpha` in [0, 1].
    double at(double alpha) const;

private:
    // Light of one pair (theta_h, azimuth): V n·l 4 v·h dh without V.
    struct Light {
        double n_dot_l;
        double weight;
    };
    // All lights of one theta_h.
    struct Ring {
        double log_sine;
        double sum = 0;  ///< over its lights, V included, where V does not know the width
        std::vector<Light> lights;
    };

    void place_rings(double step);
    void add_ring(double theta, double weight, const std::vector<UnitNode>& nodes);
    double albedo(double alpha) const;

    ClothVisibility visibility_;
    double n_dot_v_;
    std::vector<Ring> rings_;
};

/// The same over directions of light, the judge of tables: absolute error below 3e-7 (tested: two
/// steps of the rule agree). Cost: about 2 ms.
double charlie_albedo_exact(ClothVisibility visibility, double n_dot_v, double alpha,
                            double step = 1.0 / 20);

}  // namespace splitsum
