#include "splitsum/filter/texel_quadrature.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/filter/lobe_over_patch.h"
#include "splitsum/filter/reference_kernel.h"

namespace splitsum {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double gauss = 0.28867513459481288;  // 1 / (2 sqrt 3): nodes of the two-point rule

double versine_of(double angle) { return 2 * std::pow(std::sin(0.5 * angle), 2); }

// The azimuth within which (theta, azimuth) lies less than `versine` from (lobe_theta, 0).
double azimuth_within(double theta, double lobe_theta, double versine) {
    const double rest = versine - versine_of(theta - lobe_theta);
    if (rest <= 0) return 0;
    const double sines = 2 * std::sin(theta) * std::sin(lobe_theta);
    return rest >= sines ? pi : 2 * std::asin(std::sqrt(rest / sines));
}

}  // namespace

// The lobe's direction, and where it lies in the grid.
struct TexelQuadrature::Towards {
    Vec3d direction;
    double theta;
    double column;  // 0 at the left edge of column 0
};

// The columns of one row by how they must be treated, counted without wrapping around the seam:
// [begin, far0) careful, [far0, near0) plain, [near0, near1) careful, [near1, far1) plain,
// [far1, end) careful; all others do not count.
struct TexelQuadrature::RowParts {
    int begin = 0, far0 = 0, near0 = 0, near1 = 0, far1 = 0, end = 0;
};

TexelQuadrature::TexelQuadrature(const Environment& environment, double near_texels)
    : environment_(environment), near_texels_(near_texels) {
    for (size_t k = 0; k < 2; ++k)
        for (int x = 0; x < environment.width(); ++x) {
            const double azimuth = (x + 0.5 + (k ? gauss : -gauss)) * column_width() - pi;
            sin_azimuth_[k].push_back(std::sin(azimuth));
            cos_azimuth_[k].push_back(std::cos(azimuth));
        }
}

double TexelQuadrature::row_height() const { return pi / environment_.height(); }
double TexelQuadrature::column_width() const { return 2 * pi / environment_.width(); }

TexelQuadrature::Towards TexelQuadrature::towards_of(const Vec3d& direction) const {
    const LatLong at = lat_long_towards(direction);
    return {direction, pi * at.v, at.u * environment_.width()};
}

Vec3d TexelQuadrature::over_hemisphere(const Lobe& lobe, const Vec3d& direction) const {
    const Towards towards = towards_of(direction);
    Vec3d sum(0);
    for (int y = 0; y < environment_.height(); ++y)
        sum += row_integral(lobe, towards, y, hemisphere_parts(lobe, towards, y));
    return sum;
}

Vec3d TexelQuadrature::over_cap(const Lobe& lobe, const Vec3d& direction, double radius) const {
    const Towards towards = towards_of(direction);
    const int first = int(std::floor((towards.theta - radius) / row_height()));
    const int last = int(std::floor((towards.theta + radius) / row_height()));
    Vec3d sum(0);
    for (int y = std::max(0, first); y <= std::min(last, environment_.height() - 1); ++y)
        sum += row_integral(lobe, towards, y, cap_parts(lobe, towards, y, radius));
    return sum;
}

Vec3d TexelQuadrature::row_integral(const Lobe& lobe, const Towards& towards, int y,
                                    const RowParts& parts) const {
    return careful(lobe, towards, y, parts.begin, parts.far0) +
           plain(lobe, towards, y, parts.far0, parts.near0) +
           careful(lobe, towards, y, parts.near0, parts.near1) +
           plain(lobe, towards, y, parts.near1, parts.far1) +
           careful(lobe, towards, y, parts.far1, parts.end);
}

TexelQuadrature::RowParts TexelQuadrature::hemisphere_parts(const Lobe& lobe,
                                                            const Towards& towards, int y) const {
    const double half_circle = 0.5 * environment_.width();
    // The horizon's azimuth is monotonic in theta, so the row's edges bound it.
    const double edge0 = azimuth_within(y * row_height(), towards.theta, 1);
    const double edge1 = azimuth_within((y + 1) * row_height(), towards.theta, 1);
    const double inner = std::min(edge0, edge1) / column_width();
    const double outer = std::max(edge0, edge1) / column_width();

    RowParts parts;
    const bool whole_circle = outer >= half_circle - 1;
    parts.begin = int(std::floor(towards.column - (whole_circle ? half_circle : outer)));
    parts.end =
        whole_circle ? parts.begin + environment_.width() : int(std::ceil(towards.column + outer));
    const auto within = [&](double x) { return std::clamp(int(x), parts.begin, parts.end); };
    const bool no_horizon = inner >= half_circle;
    parts.far0 = no_horizon ? parts.begin : within(std::ceil(towards.column - inner));
    parts.far1 =
        no_horizon ? parts.end : std::max(parts.far0, within(std::floor(towards.column + inner)));
    mark_near(lobe, towards, y, parts);
    return parts;
}

TexelQuadrature::RowParts TexelQuadrature::cap_parts(const Lobe& lobe, const Towards& towards,
                                                     int y, double radius) const {
    // At the row's polar angle that is closest to the lobe's, so that a cap smaller than a texel
    // still has the texels it touches.
    const double closest = std::clamp(towards.theta, y * row_height(), (y + 1) * row_height());
    const double reach =
        azimuth_within(closest, towards.theta, versine_of(radius)) / column_width();
    if (reach == 0) return {};
    RowParts parts;
    parts.begin = int(std::floor(towards.column - reach));
    parts.end =
        std::min(int(std::ceil(towards.column + reach)), parts.begin + environment_.width());
    parts.far0 = parts.begin;
    parts.far1 = parts.end;
    mark_near(lobe, towards, y, parts);
    return parts;
}

void TexelQuadrature::mark_near(const Lobe& lobe, const Towards& towards, int y,
                                RowParts& parts) const {
    const double near = near_azimuth(lobe, towards.theta, y) / column_width();
    parts.near0 = parts.near1 = parts.far1;
    if (near <= 0) return;
    parts.near0 = std::clamp(int(std::floor(towards.column - near)), parts.far0, parts.far1);
    parts.near1 = std::clamp(int(std::ceil(towards.column + near)), parts.near0, parts.far1);
}

// The azimuth within which the row's texels need care because the lobe is narrow; 0 if none.
double TexelQuadrature::near_azimuth(const Lobe& lobe, double theta, int y) const {
    const double reach2 = std::pow(near_texels_ * row_height(), 2) - std::pow(lobe_width(lobe), 2);
    if (reach2 <= 0) return 0;
    const double reach = std::sqrt(reach2);
    const double top = y * row_height(), bottom = (y + 1) * row_height();
    const double closest = std::clamp(theta, top, bottom);
    if (std::abs(closest - theta) > reach) return 0;
    if (reach >= pi) return pi;
    const double versine = versine_of(reach);
    return std::max({azimuth_within(top, theta, versine), azimuth_within(closest, theta, versine),
                     azimuth_within(bottom, theta, versine)});
}

Vec3d TexelQuadrature::careful(const Lobe& lobe, const Towards& towards, int y, int begin,
                               int end) const {
    Vec3d sum(0);
    for (int x = begin; x < end; ++x) {
        const double left = (x - towards.column) * column_width();
        const double right = left + column_width();
        sum += (over_azimuths(lobe, towards.theta, y, std::max(left, -pi), std::min(right, pi)) +
                over_azimuths(lobe, towards.theta, y, left + 2 * pi, pi) +
                over_azimuths(lobe, towards.theta, y, -pi, right - 2 * pi)) *
               Vec3d(environment_.texel(wrapped(x), y));
    }
    return sum;
}

// The lobe's integral over a part of row y; 0 where the azimuths are in the wrong order.
double TexelQuadrature::over_azimuths(const Lobe& lobe, double lobe_theta, int y, double from,
                                      double to) const {
    if (to <= from) return 0;
    return lobe_over_patch(lobe, lobe_theta, {y * row_height(), (y + 1) * row_height(), from, to});
}

Vec3d TexelQuadrature::plain(const Lobe& lobe, const Towards& towards, int y, int begin,
                             int end) const {
    const auto node = [&](double row) {
        const double theta = row * row_height();
        const double sine = std::sin(theta);
        return RowNode{towards.direction.y * std::cos(theta), towards.direction.x * sine,
                       towards.direction.z * sine, 0.25 * row_height() * column_width() * sine};
    };
    const auto run = [&](int column, int count) {
        const size_t x = size_t(column);
        const size_t texel = size_t(y) * size_t(environment_.width()) + x;
        return TexelRun{size_t(count),
                        environment_.texels().data() + 4 * texel,
                        {sin_azimuth_[0].data() + x, sin_azimuth_[1].data() + x},
                        {cos_azimuth_[0].data() + x, cos_azimuth_[1].data() + x}};
    };
    const std::array<RowNode, 2> nodes = {node(y + 0.5 - gauss), node(y + 0.5 + gauss)};
    Vec3d sum(0);
    for (int x = begin; x < end;) {  // in two pieces where the seam lies between
        const int column = wrapped(x);
        const int count = std::min(end - x, environment_.width() - column);
        sum += sum_of_run(lobe, run(column, count), nodes);
        x += count;
    }
    return sum;
}

int TexelQuadrature::wrapped(int x) const {
    const int width = environment_.width();
    return ((x % width) + width) % width;
}

}  // namespace splitsum
