#include "splitsum/preview/tone_curve.h"

#include <algorithm>
#include <cmath>

namespace splitsum {

double srgb(double linear) {
    const double x = std::clamp(linear, 0.0, 1.0);
    return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}

double filmic(double linear) {
    const double x = std::max(linear, 0.0);
    return srgb(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14));
}

}  // namespace splitsum
