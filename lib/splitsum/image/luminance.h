#pragma once

#include "splitsum/math/vec.h"

namespace splitsum {

/// Of linear Rec.709 (ITU-R BT.709-6, 3.2).
inline double luminance(const Vec3d& rgb) { return dot(rgb, Vec3d(0.2126, 0.7152, 0.0722)); }

}  // namespace splitsum
