#pragma once

#include <vector>

#include "splitsum/brdf/lobe.h"

namespace splitsum {

/// The factors k_l by which the lobe scales bands 0 .. count - 1 (Funk 1916, Hecke 1918):
///     k_l = ∫ K(c) P_l(c) dc / ∫ K(c) dc,   so that k_0 = 1 and |k_l| <= 1.
/// Gauss-Legendre in the angle, on panels that start at a fraction of the lobe's width and grow;
/// absolute error below 1e-12 (tested against the closed form of the clamped cosine, Ramamoorthi &
/// Hanrahan 2001, eq. 19). A GGX lobe of alpha 0 is the mirror: every factor is 1. Cost: O(count²),
/// about 25 ms for 2000 bands.
std::vector<double> band_factors(const Lobe& lobe, int count);

}  // namespace splitsum
