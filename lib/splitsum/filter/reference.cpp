#include "splitsum/filter/reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "splitsum/filter/lobe_over_patch.h"
#include "splitsum/filter/reference_kernel.h"

namespace splitsum {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double gauss = 0.28867513459481288;  // 1 / (2 sqrt 3): nodes of the two-point rule
constexpr double near_texels = 25;             // where 2 x 2 points would lose 1e-9

// The columns of one row by how they must be treated, counted without wrapping around the seam:
// [begin, far0) careful, [far0, near0) plain, [near0, near1) careful, [near1, far1) plain,
// [far1, end) careful; all others are below the horizon.
struct RowParts {
    int begin, far0, near0, near1, far1, end;
};

// The azimuth within which (theta, azimuth) lies less than `versine` from (lobe_theta, 0).
double azimuth_within(double theta, double lobe_theta, double versine) {
    const double rest = versine - 2 * std::pow(std::sin(0.5 * (theta - lobe_theta)), 2);
    if (rest <= 0) return 0;
    const double sines = 2 * std::sin(theta) * std::sin(lobe_theta);
    return rest >= sines ? pi : 2 * std::asin(std::sqrt(rest / sines));
}

class ReferenceFilter final : public PreparedFilter {
public:
    ReferenceFilter(const Environment& environment, std::span<const Lobe> lobes)
        : environment_(environment), lobes_(lobes.begin(), lobes.end()) {
        for (const Lobe& lobe : lobes) integrals_.push_back(lobe_integral(lobe));
        for (size_t k = 0; k < 2; ++k)
            for (int x = 0; x < environment.width(); ++x) {
                const double azimuth = (x + 0.5 + (k ? gauss : -gauss)) * column_width() - pi;
                sin_azimuth_[k].push_back(std::sin(azimuth));
                cos_azimuth_[k].push_back(std::cos(azimuth));
            }
    }

    void evaluate(size_t lobe_index, const Directions& directions,
                  std::span<Vec3> out) const override {
        for (size_t i = 0; i < out.size(); ++i)
            out[i] = Vec3(integral(lobes_[lobe_index], directions.towards[i]) /
                          integrals_[lobe_index]);
    }

private:
    struct Towards {
        Vec3d direction;
        double theta;
        double azimuth;
        double column;  // the azimuth as a column, 0 at the left edge of column 0
    };

    double row_height() const { return pi / environment_.height(); }
    double column_width() const { return 2 * pi / environment_.width(); }

    Vec3d integral(const Lobe& lobe, const Vec3d& direction) const {
        const LatLong at = lat_long_towards(direction);
        const Towards towards{direction, pi * at.v, 2 * pi * (at.u - 0.5),
                              at.u * environment_.width()};
        Vec3d sum(0);
        for (int y = 0; y < environment_.height(); ++y) sum += row_integral(lobe, towards, y);
        return sum;
    }

    Vec3d row_integral(const Lobe& lobe, const Towards& towards, int y) const {
        const RowParts parts = parts_of_row(lobe, towards.theta, towards.column, y);
        return careful(lobe, towards, y, parts.begin, parts.far0) +
               plain(lobe, towards, y, parts.far0, parts.near0) +
               careful(lobe, towards, y, parts.near0, parts.near1) +
               plain(lobe, towards, y, parts.near1, parts.far1) +
               careful(lobe, towards, y, parts.far1, parts.end);
    }

    RowParts parts_of_row(const Lobe& lobe, double theta, double column, int y) const {
        const double top = y * row_height(), bottom = (y + 1) * row_height();
        const double half_circle = 0.5 * environment_.width();
        // The horizon azimuth is monotonic in theta, so the row's edges bound it.
        const double edge0 = azimuth_within(top, theta, 1), edge1 = azimuth_within(bottom, theta, 1);
        const double inner = std::min(edge0, edge1) / column_width();
        const double outer = std::max(edge0, edge1) / column_width();
        const double near = near_azimuth(lobe, theta, y) / column_width();

        RowParts parts;
        const bool whole_circle = outer >= half_circle - 1;
        parts.begin = int(std::floor(column - (whole_circle ? half_circle : outer)));
        parts.end = whole_circle ? parts.begin + environment_.width()
                                 : int(std::ceil(column + outer));
        const auto within = [&](double x) {
            return std::clamp(int(x), parts.begin, parts.end);
        };
        const bool no_horizon = inner >= half_circle;
        parts.far0 = no_horizon ? parts.begin : within(std::ceil(column - inner));
        parts.far1 = no_horizon ? parts.end : std::max(parts.far0, within(std::floor(column + inner)));
        const bool has_near = near > 0;
        parts.near0 = has_near ? std::clamp(int(std::floor(column - near)), parts.far0, parts.far1)
                               : parts.far1;
        parts.near1 = has_near ? std::clamp(int(std::ceil(column + near)), parts.near0, parts.far1)
                               : parts.far1;
        return parts;
    }

    // The azimuth within which the row's texels need care because the lobe is narrow; 0 if none.
    double near_azimuth(const Lobe& lobe, double theta, int y) const {
        const double reach2 = std::pow(near_texels * row_height(), 2) - std::pow(lobe_width(lobe), 2);
        if (reach2 <= 0) return 0;
        const double reach = std::sqrt(reach2);
        const double top = y * row_height(), bottom = (y + 1) * row_height();
        const double closest = std::clamp(theta, top, bottom);
        if (std::abs(closest - theta) > reach) return 0;
        if (reach >= pi) return pi;
        const double versine = 2 * std::pow(std::sin(0.5 * reach), 2);
        return std::max({azimuth_within(top, theta, versine), azimuth_within(closest, theta, versine),
                         azimuth_within(bottom, theta, versine)});
    }

    Vec3d careful(const Lobe& lobe, const Towards& towards, int y, int begin, int end) const {
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
    double over_azimuths(const Lobe& lobe, double lobe_theta, int y, double from, double to) const {
        if (to <= from) return 0;
        return lobe_over_patch(lobe, lobe_theta,
                               {y * row_height(), (y + 1) * row_height(), from, to});
    }

    Vec3d plain(const Lobe& lobe, const Towards& towards, int y, int begin, int end) const {
        const std::array<RowNode, 2> nodes = {row_node(towards.direction, y + 0.5 - gauss),
                                              row_node(towards.direction, y + 0.5 + gauss)};
        Vec3d sum(0);
        for (int x = begin; x < end;) {  // in two pieces where the seam lies between
            const int column = wrapped(x);
            const int count = std::min(end - x, environment_.width() - column);
            sum += sum_of_run(lobe, run_of(column, y, count), nodes);
            x += count;
        }
        return sum;
    }

    RowNode row_node(const Vec3d& direction, double row) const {
        const double theta = row * row_height();
        const double sine = std::sin(theta);
        const double weight = 0.25 * row_height() * column_width() * sine;
        return {direction.y * std::cos(theta), direction.x * sine, direction.z * sine, weight};
    }

    TexelRun run_of(int column, int y, int count) const {
        const size_t x = size_t(column);
        const size_t texel = size_t(y) * size_t(environment_.width()) + x;
        return {size_t(count),
                environment_.texels().data() + 4 * texel,
                {sin_azimuth_[0].data() + x, sin_azimuth_[1].data() + x},
                {cos_azimuth_[0].data() + x, cos_azimuth_[1].data() + x}};
    }

    int wrapped(int x) const {
        const int width = environment_.width();
        return ((x % width) + width) % width;
    }

    const Environment& environment_;
    std::vector<Lobe> lobes_;
    std::vector<double> integrals_;
    std::array<std::vector<double>, 2> sin_azimuth_;  // at both Gauss points of every column
    std::array<std::vector<double>, 2> cos_azimuth_;
};

}  // namespace

std::unique_ptr<PreparedFilter> prepare_reference(const Environment& environment,
                                                  std::span<const Lobe> lobes, const FilterPlan&) {
    return std::make_unique<ReferenceFilter>(environment, lobes);
}

}  // namespace splitsum
