#include "splitsum/table/split_sum_importance.h"

#include <cmath>
#include <numbers>

#include "splitsum/math/low_discrepancy.h"
#include "splitsum/table/split_sum_rows_detail.h"

namespace splitsum {
namespace {

// A point of the unit square, its azimuth as the cosine.
struct Point {
    double xi;
    double cos_azimuth;
};

std::vector<Point> make_points(int samples) {
    std::vector<Point> points;
    for (int i = 0; i < samples; ++i) {
        const Vec2d u = hammersley(static_cast<uint32_t>(i), static_cast<uint32_t>(samples));
        points.push_back({u.x, std::cos(2 * std::numbers::pi * u.y)});
    }
    return points;
}

// With t = tan theta = alpha sqrt(xi / (1 - xi)) and v·h, n·l times 1 + t² taken together, nothing
// cancels in a narrow lobe.
SplitSum sample_texel(SmithTerm term, double n_dot_v, double alpha,
                      const std::vector<Point>& points) {
    if (alpha <= 0) return mirror_split_sum(n_dot_v);
    const double sin_v = std::sqrt((1 - n_dot_v) * (1 + n_dot_v));
    SplitSum sum{0, 0};
    for (const Point& point : points) {
        const double tan2 = alpha * alpha * point.xi / (1 - point.xi);
        const double across = sin_v * std::sqrt(tan2) * point.cos_azimuth;
        const double n_dot_l = (2 * across + n_dot_v * (1 - tan2)) / (1 + tan2);
        if (n_dot_l <= 0) continue;
        // v·h / n·h, and v·h itself.
        const double v_dot_h_over_n_dot_h = across + n_dot_v;
        const double v_dot_h = v_dot_h_over_n_dot_h / std::sqrt(1 + tan2);
        const double weight =
            4 * smith_visibility(term, n_dot_l, n_dot_v, alpha) * n_dot_l * v_dot_h_over_n_dot_h;
        const double away2 = (1 - v_dot_h) * (1 - v_dot_h);
        const double fresnel = away2 * away2 * (1 - v_dot_h);
        sum.a += (1 - fresnel) * weight;
        sum.b += fresnel * weight;
    }
    const double count = static_cast<double>(points.size());
    return {sum.a / count, sum.b / count};
}

}  // namespace

SplitSum split_sum_by_importance(SmithTerm term, double n_dot_v, double alpha, int samples) {
    return sample_texel(term, n_dot_v, alpha, make_points(samples));
}

std::vector<SplitSum> split_sums_by_importance(const TablePlan& plan, const TableGrid& grid,
                                               Progress& progress) {
    const std::vector<Point> points = make_points(plan.samples);
    return split_sums_texel_by_texel(grid, progress, [&](double n_dot_v, double alpha) {
        return sample_texel(plan.geometry, n_dot_v, alpha, points);
    });
}

}  // namespace splitsum
