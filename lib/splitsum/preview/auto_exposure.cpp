#include "splitsum/preview/auto_exposure.h"

#include <algorithm>
#include <cmath>

#include "splitsum/image/luminance.h"
#include "splitsum/picture/exposure.h"

namespace splitsum {

double auto_exposure_stops(const Cubemap& light) {
    constexpr double brightest_white = 0.4;
    const double mean = luminance(mean_radiance(light));
    if (!(mean > 0)) return 0;
    return std::min(exposure_stops_of(light), std::log2(brightest_white / mean));
}

}  // namespace splitsum
