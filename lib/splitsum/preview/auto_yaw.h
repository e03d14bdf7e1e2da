#pragma once

#include "splitsum/sphere/cubemap.h"

namespace splitsum {

/// A yaw in degrees, as Viewpoint has it, at which the light models what is seen: most of it comes
/// from the left and a little from behind the viewer. Between -180 and 180, in steps of 5, so that two
/// bakes of one panorama are seen alike. 0 for light that comes from all around or from above.
/// `irradiance`: by normal, of any unit.
double auto_yaw_degrees(const Cubemap& irradiance);

}  // namespace splitsum
