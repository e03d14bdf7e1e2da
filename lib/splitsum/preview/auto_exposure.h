#pragma once

#include "splitsum/sphere/cubemap.h"

namespace splitsum {

/// The exposure in stops at which lit things are shown unless somebody says otherwise: that of
/// contact sheets (picture/exposure.h) for the light itself, level 0 of a chain, but no more than
/// shows its mean luminance, which is what white surfaces have on average, at 0.4. A dark sky with
/// few lamps would else bleach what the lamps shine on. 0 for black light.
double auto_exposure_stops(const Cubemap& light);

}  // namespace splitsum
