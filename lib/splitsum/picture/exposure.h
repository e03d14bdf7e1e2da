#pragma once

#include "splitsum/sphere/cubemap.h"

namespace splitsum {

/// The exposure in stops at which light is shown to people: it brings the geometric mean of the
/// cubemap's mean luminance and its logarithmic mean luminance (Reinhard et al. 2002, eq. 1) to
/// 0.25, so that neither a sun nor darkness decides alone. 0 for a black cubemap.
double exposure_stops_of(const Cubemap& radiance);

}  // namespace splitsum
