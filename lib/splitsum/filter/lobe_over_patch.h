#pragma once

#include "splitsum/brdf/lobe.h"

namespace splitsum {

/// A patch of the sphere between two polar angles and two azimuths, the latter measured from the
/// lobe's direction and within half a turn of it (a little more is harmless).
struct LatLongPatch {
    double theta0, theta1;
    double azimuth0, azimuth1;
};

/// The integral over the patch of a lobe whose direction has polar angle `lobe_theta` and azimuth
/// 0, wherever the patch lies: on the peak, across the horizon, at a pole.
///
/// The patch is halved until it is smaller than half the distance to the lobe's complex poles,
/// where Gauss-Legendre converges like (1/8)^(2 n); each row of nodes ends at the horizon, so the
/// kink there costs nothing. Relative error below 1e-9; up to 3e-7 of the whole lobe where the horizon
/// runs nearly along the rows (tested by sums over whole spheres).
double lobe_over_patch(const Lobe& lobe, double lobe_theta, const LatLongPatch& patch);

}  // namespace splitsum
