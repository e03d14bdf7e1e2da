#include "splitsum/filter/row_quadrature.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/filter/lobe_over_patch.h"
#include "splitsum/filter/reference_kernel.h"
#include "splitsum/sphere/environment.h"

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

// A point of polar angle theta whose azimuth is `step` more than that of the texel's middle:
// sin(azimuth + step) = sin(azimuth) cos(step) + cos(azimuth) sin(step), and so on.
TexelNode texel_node(const Vec3d& towards, double theta, double sin_theta, double step) {
    const double sine = std::sin(step), cosine = std::cos(step);
    return {towards.y * std::cos(theta), sin_theta * (towards.x * cosine - towards.z * sine),
            sin_theta * (towards.z * cosine + towards.x * sine)};
}

}  // namespace

// The columns of one row by how they must be treated, counted without wrapping around the seam:
// [begin, far0) careful, [far0, near0) plain, [near0, near1) careful, [near1, far1) plain,
// [far1, end) careful; all others do not count.
struct RowQuadrature::RowParts {
    int begin = 0, far0 = 0, near0 = 0, near1 = 0, far1 = 0, end = 0;
};

RowQuadrature::RowQuadrature(int height, double near_texels)
    : height_(height), near_texels_(near_texels) {
    for (int x = 0; x < width(); ++x) {
        const double azimuth = (x + 0.5) * column_width() - pi;
        sin_azimuth_.push_back(std::sin(azimuth));
        cos_azimuth_.push_back(std::cos(azimuth));
    }
}

double RowQuadrature::row_height() const { return pi / height_; }
double RowQuadrature::column_width() const { return pi / height_; }

RowQuadrature::Towards RowQuadrature::towards(const Vec3d& direction) const {
    const LatLong at = lat_long_towards(direction);
    return {direction, pi * at.v, at.u * width()};
}

Vec3d RowQuadrature::over_hemisphere(const Lobe& lobe, const Towards& towards,
                                     const TexelRow& row) const {
    return row_integral(lobe, towards, row, hemisphere_parts(lobe, towards, row.y));
}

Vec3d RowQuadrature::over_cap(const Lobe& lobe, const Towards& towards, const TexelRow& row,
                              double radius) const {
    return row_integral(lobe, towards, row, cap_parts(lobe, towards, row.y, radius));
}

Vec3d RowQuadrature::row_integral(const Lobe& lobe, const Towards& towards, const TexelRow& row,
                                  const RowParts& parts) const {
    return careful(lobe, towards, row, parts.begin, parts.far0) +
           plain(lobe, towards, row, parts.far0, parts.near0) +
           careful(lobe, towards, row, parts.near0, parts.near1) +
           plain(lobe, towards, row, parts.near1, parts.far1) +
           careful(lobe, towards, row, parts.far1, parts.end);
}

RowQuadrature::RowParts RowQuadrature::hemisphere_parts(const Lobe& lobe, const Towards& towards,
                                                        int y) const {
    const double half_circle = 0.5 * width();
    // The horizon's azimuth is monotonic in theta, so the row's edges bound it.
    const double edge0 = azimuth_within(y * row_height(), towards.theta, 1);
    const double edge1 = azimuth_within((y + 1) * row_height(), towards.theta, 1);
    const double inner = std::min(edge0, edge1) / column_width();
    const double outer = std::max(edge0, edge1) / column_width();

    RowParts parts;
    const bool whole_circle = outer >= half_circle - 1;
    parts.begin = int(std::floor(towards.column - (whole_circle ? half_circle : outer)));
    parts.end = whole_circle ? parts.begin + width() : int(std::ceil(towards.column + outer));
    const auto within = [&](double x) { return std::clamp(int(x), parts.begin, parts.end); };
    const bool no_horizon = inner >= half_circle;
    parts.far0 = no_horizon ? parts.begin : within(std::ceil(towards.column - inner));
    parts.far1 =
        no_horizon ? parts.end : std::max(parts.far0, within(std::floor(towards.column + inner)));
    mark_near(lobe, towards, y, parts);
    return parts;
}

RowQuadrature::RowParts RowQuadrature::cap_parts(const Lobe& lobe, const Towards& towards, int y,
                                                 double radius) const {
    // At the row's polar angle that is closest to the lobe's, so that a cap smaller than a texel
    // still has the texels it touches.
    const double closest = std::clamp(towards.theta, y * row_height(), (y + 1) * row_height());
    const double reach =
        azimuth_within(closest, towards.theta, versine_of(radius)) / column_width();
    if (reach == 0) return {};
    RowParts parts;
    parts.begin = int(std::floor(towards.column - reach));
    parts.end = std::min(int(std::ceil(towards.column + reach)), parts.begin + width());
    parts.far0 = parts.begin;
    parts.far1 = parts.end;
    mark_near(lobe, towards, y, parts);
    return parts;
}

void RowQuadrature::mark_near(const Lobe& lobe, const Towards& towards, int y,
                              RowParts& parts) const {
    const double near = near_azimuth(lobe, towards.theta, y) / column_width();
    parts.near0 = parts.near1 = parts.far1;
    if (near <= 0) return;
    parts.near0 = std::clamp(int(std::floor(towards.column - near)), parts.far0, parts.far1);
    parts.near1 = std::clamp(int(std::ceil(towards.column + near)), parts.near0, parts.far1);
}

// The azimuth within which the row's texels need care because the lobe is narrow; 0 if none.
double RowQuadrature::near_azimuth(const Lobe& lobe, double theta, int y) const {
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

Vec3d RowQuadrature::careful(const Lobe& lobe, const Towards& towards, const TexelRow& row,
                             int begin, int end) const {
    Vec3d sum(0);
    for (int x = begin; x < end; ++x) {
        const double left = (x - towards.column) * column_width();
        const double right = left + column_width();
        sum +=
            (over_azimuths(lobe, towards.theta, row.y, std::max(left, -pi), std::min(right, pi)) +
             over_azimuths(lobe, towards.theta, row.y, left + 2 * pi, pi) +
             over_azimuths(lobe, towards.theta, row.y, -pi, right - 2 * pi)) *
            Vec3d(row.texel(wrapped(x)));
    }
    return sum;
}

// The lobe's integral over a part of row y; 0 where the azimuths are in the wrong order.
double RowQuadrature::over_azimuths(const Lobe& lobe, double lobe_theta, int y, double from,
                                    double to) const {
    if (to <= from) return 0;
    return lobe_over_patch(lobe, lobe_theta, {y * row_height(), (y + 1) * row_height(), from, to});
}

Vec3d RowQuadrature::plain(const Lobe& lobe, const Towards& towards, const TexelRow& row, int begin,
                           int end) const {
    const double theta_step = gauss * row_height(), azimuth_step = gauss * column_width();
    const double theta_middle = (row.y + 0.5) * row_height();
    TexelNodes nodes;
    for (size_t n = 0; n < 2; ++n) {
        const double theta = theta_middle + (n ? theta_step : -theta_step);
        const double sine = std::sin(theta);
        nodes.weights[n] = 0.25 * row_height() * column_width() * sine;
        for (size_t k = 0; k < 2; ++k)
            nodes.nodes[n][k] =
                texel_node(towards.direction, theta, sine, k ? azimuth_step : -azimuth_step);
    }
    const auto run = [&](int column, int count) {
        const size_t x = size_t(column);
        return TexelRun{size_t(count), row.texels + size_t(row.floats_per_texel) * x,
                        row.floats_per_texel, sin_azimuth_.data() + x, cos_azimuth_.data() + x};
    };
    Vec3d sum(0);
    for (int x = begin; x < end;) {  // in two pieces where the seam lies between
        const int column = wrapped(x);
        const int count = std::min(end - x, width() - column);
        sum += sum_of_run(lobe, run(column, count), nodes);
        x += count;
    }
    return sum;
}

int RowQuadrature::wrapped(int x) const { return ((x % width()) + width()) % width(); }

}  // namespace splitsum
