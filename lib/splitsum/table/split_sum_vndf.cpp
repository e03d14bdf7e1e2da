#include "splitsum/table/split_sum_vndf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "splitsum/brdf/smith.h"
#include "splitsum/math/low_discrepancy.h"
#include "splitsum/table/split_sum_rows_detail.h"

namespace splitsum {
namespace {

// How the kernel is laid out: `lane_count` points are evaluated side by side, which compilers turn
// into SIMD, and fp32 sums are handed to fp64 after every block.
constexpr size_t lane_count = 8;
constexpr size_t block_size = 512;
// Narrower lobes are the mirror: the table differs from its limit by less than alpha.
constexpr double narrowest_alpha = 1e-12;
using Lanes = std::array<float, lane_count>;

// The sample points, the same for all texels: height on the cap and azimuth in [0, pi], which is
// enough because the integrand is even. `weight` is 1 / samples, and 0 in the padding at the end.
struct PointSet {
    std::vector<float> height;
    std::vector<float> cos_phi;
    std::vector<float> sin_phi;
    std::vector<float> weight;
};

PointSet make_points(int samples) {
    const size_t count = static_cast<size_t>(samples);
    const size_t padded = (count + lane_count - 1) / lane_count * lane_count;
    PointSet points{std::vector<float>(padded, 0.5F), std::vector<float>(padded),
                    std::vector<float>(padded), std::vector<float>(padded)};
    for (size_t i = 0; i < count; ++i) {
        const Vec2d u = hammersley(static_cast<uint32_t>(i), static_cast<uint32_t>(count));
        const double phi = std::numbers::pi * u.y;
        points.height[i] = static_cast<float>(u.x);
        points.cos_phi[i] = static_cast<float>(std::cos(phi));
        points.sin_phi[i] = static_cast<float>(std::sin(phi));
        points.weight[i] = static_cast<float>(1.0 / samples);
    }
    return points;
}

// What stays the same for all points of a texel.
struct Texel {
    float alpha;
    float one_minus_alpha2;
    float alpha2;
    float view_x;  // v = (view_x, 0, view_z)
    float view_z;
    float stretched_x;    // v stretched by the width and normalised again
    float cap_height;     // 1 + stretched z
    float cap_remainder;  // 1 - stretched z, from the sine: at small alpha the difference cancels
    float view_length;    // sqrt(view_z² (1 - alpha²) + alpha²), the Smith term of the view
    float schlick_k;
    float schlick_view;  // G1(v) of Schlick over G1(v) of GGX
};

Texel make_texel(SmithTerm term, double n_dot_v, double alpha) {
    const double sin_v = std::sqrt((1 - n_dot_v) * (1 + n_dot_v));
    const double stretched_length = std::hypot(alpha * sin_v, n_dot_v);
    const double stretched_x = alpha * sin_v / stretched_length;
    const double cap_height = 1 + n_dot_v / stretched_length;
    const double view_length = std::sqrt(n_dot_v * n_dot_v * (1 - alpha * alpha) + alpha * alpha);
    const double k = schlick_k(term, alpha);
    const double schlick_view = 0.5 * (n_dot_v + view_length) / (n_dot_v * (1 - k) + k);
    return {.alpha = static_cast<float>(alpha),
            .one_minus_alpha2 = static_cast<float>(1 - alpha * alpha),
            .alpha2 = static_cast<float>(alpha * alpha),
            .view_x = static_cast<float>(sin_v),
            .view_z = static_cast<float>(n_dot_v),
            .stretched_x = static_cast<float>(stretched_x),
            .cap_height = static_cast<float>(cap_height),
            .cap_remainder = static_cast<float>(stretched_x * stretched_x / cap_height),
            .view_length = static_cast<float>(view_length),
            .schlick_k = static_cast<float>(k),
            .schlick_view = static_cast<float>(schlick_view)};
}

// G2 / G1(v), where G1 is that of the visible normals: GGX Smith. 0 where n·l is.
struct HeightCorrelated {
    static float masking_ratio(const Texel& at, float n_dot_l) {
        const float light_length = std::sqrt(n_dot_l * n_dot_l * at.one_minus_alpha2 + at.alpha2);
        return n_dot_l * (at.view_z + at.view_length) /
               (n_dot_l * at.view_length + at.view_z * light_length);
    }
};

struct Schlick {
    static float masking_ratio(const Texel& at, float n_dot_l) {
        return at.schlick_view * n_dot_l / (n_dot_l * (1 - at.schlick_k) + at.schlick_k);
    }
};

// One sample: the visible normal h of brdf/visible_normals.h in fp32, not normalised; n·l |h|² is
// 2 (v·h) h.z - v.z |h|² with the squares of h.z taken together, so that nothing cancels.
template <class Smith>
void add_sample(const Texel& at, float u, float cos_phi, float sin_phi, float weight, float& a,
                float& b) {
    const float z = (1 - u) * at.cap_height;
    const float sin_theta = std::sqrt(u * at.cap_height * (z + at.cap_remainder));
    const float x = at.alpha * (sin_theta * cos_phi + at.stretched_x);
    const float y = at.alpha * sin_theta * sin_phi;
    const float slope2 = x * x + y * y;
    const float inverse2 = 1 / (slope2 + z * z);
    const float signed_n_dot_l = (2 * at.view_x * x * z + at.view_z * (z * z - slope2)) * inverse2;
    const float v_dot_h = (at.view_x * x + at.view_z * z) * std::sqrt(inverse2);
    // The larger of this and 0, without a branch: below the horizon the masking ratio is 0.
    const float n_dot_l = 0.5F * (signed_n_dot_l + std::abs(signed_n_dot_l));
    const float ratio = weight * Smith::masking_ratio(at, n_dot_l);
    const float away = 1 - v_dot_h;
    const float away2 = away * away;
    const float fresnel = away2 * away2 * away;
    a += (1 - fresnel) * ratio;
    b += fresnel * ratio;
}

template <class Smith>
SplitSum sum_block(const Texel& at, const PointSet& points, size_t from, size_t to) {
    Lanes a{};
    Lanes b{};
    for (size_t i = from; i < to; i += lane_count)
        for (size_t lane = 0; lane < lane_count; ++lane)
            add_sample<Smith>(at, points.height[i + lane], points.cos_phi[i + lane],
                              points.sin_phi[i + lane], points.weight[i + lane], a[lane], b[lane]);
    SplitSum sum{0, 0};
    for (size_t lane = 0; lane < lane_count; ++lane) {
        sum.a += static_cast<double>(a[lane]);
        sum.b += static_cast<double>(b[lane]);
    }
    return sum;
}

template <class Smith>
SplitSum sum_points(const Texel& at, const PointSet& points) {
    SplitSum sum{0, 0};
    for (size_t from = 0; from < points.weight.size(); from += block_size) {
        const size_t to = std::min(points.weight.size(), from + block_size);
        const SplitSum block = sum_block<Smith>(at, points, from, to);
        sum = {sum.a + block.a, sum.b + block.b};
    }
    return sum;
}

SplitSum sample_texel(SmithTerm term, double n_dot_v, double alpha, const PointSet& points) {
    if (alpha < narrowest_alpha) {
        const double fresnel = std::pow(1 - n_dot_v, 5);
        return {1 - fresnel, fresnel};
    }
    const Texel at = make_texel(term, n_dot_v, alpha);
    return term == SmithTerm::height_correlated ? sum_points<HeightCorrelated>(at, points)
                                                : sum_points<Schlick>(at, points);
}

}  // namespace

SplitSum split_sum_by_visible_normals(SmithTerm term, double n_dot_v, double alpha, int samples) {
    return sample_texel(term, n_dot_v, alpha, make_points(samples));
}

std::vector<SplitSum> split_sums_by_visible_normals(const TablePlan& plan, const TableGrid& grid,
                                                    Progress& progress) {
    const PointSet points = make_points(plan.samples);
    return split_sums_texel_by_texel(grid, progress, [&](double n_dot_v, double alpha) {
        return sample_texel(plan.geometry, n_dot_v, alpha, points);
    });
}

}  // namespace splitsum
