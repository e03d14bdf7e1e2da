#include "splitsum/filter/narrow_lobe.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace splitsum {
namespace {

// Beyond s = sin²(theta / 2) the normalised lobes differ by 2 alpha² wide² / s³ to leading order,
// which integrates to alpha² wide² / s² of the whole.
double cap_radius(double alpha, double wide_alpha, double accuracy) {
    const double s = alpha * wide_alpha / std::sqrt(accuracy);
    return std::min(0.45 * std::numbers::pi, 2 * std::asin(std::min(1.0, std::sqrt(s))));
}

}  // namespace

NarrowLobe::NarrowLobe(double alpha, double wide_alpha, double accuracy)
    : lobe_{LobeKind::ggx, alpha},
      wide_{LobeKind::ggx, wide_alpha},
      share_(alpha * alpha / (wide_alpha * wide_alpha)),
      cap_radius_(cap_radius(alpha, wide_alpha, accuracy)) {
    const double integral = lobe_integral(lobe_), wide_integral = lobe_integral(wide_);
    const double inside = lobe_integral_within(lobe_, cap_radius_) / integral -
                          share_ * lobe_integral_within(wide_, cap_radius_) / wide_integral;
    const double whole = (1 - share_) / inside;
    factor_ = whole / integral;
    wide_factor_ = whole * share_ / wide_integral;
}

Vec3d NarrowLobe::rest(const TexelQuadrature& quadrature, const Vec3d& direction) const {
    return factor_ * quadrature.over_cap(lobe_, direction, cap_radius_) -
           wide_factor_ * quadrature.over_cap(wide_, direction, cap_radius_);
}

}  // namespace splitsum
