#include "splitsum/filter/texel_quadrature.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace splitsum {

TexelQuadrature::TexelQuadrature(const Environment& environment, double near_texels)
    : environment_(environment), rows_(environment.height(), near_texels) {}

TexelRow TexelQuadrature::row(int y) const {
    return {y, environment_.texels().data() + 4 * size_t(y) * size_t(environment_.width()), 4};
}

Vec3d TexelQuadrature::over_hemisphere(const Lobe& lobe, const Vec3d& direction) const {
    const auto towards = rows_.towards(direction);
    Vec3d sum(0);
    for (int y = 0; y < rows_.height(); ++y) sum += rows_.over_hemisphere(lobe, towards, row(y));
    return sum;
}

Vec3d TexelQuadrature::over_cap(const Lobe& lobe, const Vec3d& direction, double radius) const {
    const auto towards = rows_.towards(direction);
    const double row_height = std::numbers::pi / rows_.height();
    const int first = int(std::floor((towards.theta - radius) / row_height));
    const int last = int(std::floor((towards.theta + radius) / row_height));
    Vec3d sum(0);
    for (int y = std::max(0, first); y <= std::min(last, rows_.height() - 1); ++y)
        sum += rows_.over_cap(lobe, towards, row(y), radius);
    return sum;
}

}  // namespace splitsum
