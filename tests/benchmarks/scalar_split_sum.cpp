#include "scalar_split_sum.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/math/low_discrepancy.h"

namespace splitsum::benchmarks {
namespace {

struct Point {
    float xi;
    float cos_azimuth;
};

std::vector<Point> points_of(int samples) {
    std::vector<Point> points;
    for (int i = 0; i < samples; ++i) {
        const Vec2d u = hammersley(uint32_t(i), uint32_t(samples));
        points.push_back({float(u.x), float(std::cos(2 * std::numbers::pi * u.y))});
    }
    return points;
}

// V = G / (4 n·l n·v) in single precision.
float visibility(SmithTerm term, float n_dot_l, float n_dot_v, float alpha) {
    if (term == SmithTerm::height_correlated) {
        const float a2 = alpha * alpha;
        const float v = n_dot_l * std::sqrt(n_dot_v * n_dot_v * (1 - a2) + a2);
        const float l = n_dot_v * std::sqrt(n_dot_l * n_dot_l * (1 - a2) + a2);
        return 0.5f / (v + l);
    }
    const float k = float(schlick_k(term, double(alpha)));
    return 0.25f / ((n_dot_l * (1 - k) + k) * (n_dot_v * (1 - k) + k));
}

// The weight of a half vector drawn from D is 4 V n·l v·h / n·h.
Vec2 scalar_texel(SmithTerm term, float n_dot_v, float alpha, const std::vector<Point>& points) {
    const float sin_v = std::sqrt(1 - n_dot_v * n_dot_v);
    Vec2 sum(0);
    for (const Point& point : points) {
        const float n_dot_h = std::sqrt((1 - point.xi) / (1 + (alpha * alpha - 1) * point.xi));
        const float sin_h = std::sqrt(std::max(0.0f, 1 - n_dot_h * n_dot_h));
        const float v_dot_h = sin_v * sin_h * point.cos_azimuth + n_dot_v * n_dot_h;
        const float n_dot_l = 2 * v_dot_h * n_dot_h - n_dot_v;
        if (n_dot_l <= 0 || v_dot_h <= 0) continue;
        const float weight =
            4 * visibility(term, n_dot_l, n_dot_v, alpha) * n_dot_l * v_dot_h / n_dot_h;
        const float away = 1 - v_dot_h;
        const float fresnel = away * away * away * away * away;
        sum += weight * Vec2(1 - fresnel, fresnel);
    }
    return sum / float(points.size());
}

}  // namespace

Table scalar_split_sum_table(SmithTerm term, int size, int samples) {
    const std::vector<Point> points = points_of(samples);
    Table table = blank_table(size, size, 2);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const float perceptual_roughness = (float(y) + 0.5f) / float(size);
            const Vec2 sum = scalar_texel(term, (float(x) + 0.5f) / float(size),
                                          perceptual_roughness * perceptual_roughness, points);
            table.texel(x, y)[0] = sum.x;
            table.texel(x, y)[1] = sum.y;
        }
    return table;
}

}  // namespace splitsum::benchmarks
