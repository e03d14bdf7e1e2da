#include "skies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "splitsum/base/random.h"

namespace splitsum::test_data {
namespace {

constexpr double pi = std::numbers::pi;

// u and v run from 0 to 1, right and down.
Vec3d direction_at(double u, double v) {
    const double azimuth = (u - 0.5) * 2 * pi, polar = v * pi;
    return {std::sin(polar) * std::sin(azimuth), std::cos(polar),
            std::sin(polar) * std::cos(azimuth)};
}

double smooth_step(double from, double to, double x) {
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

/// A flat light: a convex polygon whose corners run around it, each shining `radiance`.
struct PolygonLight {
    std::array<Vec3d, 4> corners;
    Vec3d radiance;
};

// Inside the pyramid over the polygon: on the same side of every plane through the eye and an edge.
bool is_seen(const PolygonLight& light, const Vec3d& direction) {
    bool all_left = true, all_right = true;
    for (size_t i = 0; i < light.corners.size(); ++i) {
        const Vec3d edge_plane =
            cross(light.corners[i], light.corners[(i + 1) % light.corners.size()]);
        const double side = dot(edge_plane, direction);
        all_left &= side > 0;
        all_right &= side < 0;
    }
    const Vec3d middle = light.corners[0] + light.corners[2];
    return (all_left || all_right) && dot(middle, direction) > 0;
}

/// A round lamp of `radius` radians about `direction`.
struct Lamp {
    Vec3d direction;
    double radius;
    Vec3d radiance;
};

Lamp street_lamp(uint32_t index) {
    static constexpr std::array<std::array<double, 3>, 4> colors = {
        {{1.0, 0.55, 0.2}, {1.0, 0.15, 0.1}, {0.25, 0.9, 0.5}, {0.4, 0.55, 1.0}}};
    const double azimuth = 2 * pi * unit_float(4 * index);
    const double height = 0.02 + 0.22 * unit_float(4 * index + 1);
    const auto& color = colors[mix_bits(4 * index + 2) % colors.size()];
    const double radiance = 20 + 300 * unit_float(4 * index + 3);
    return {normalize(Vec3d(std::sin(azimuth), height, std::cos(azimuth))),
            0.012 + 0.02 * unit_float(mix_bits(index)),
            radiance * Vec3d(color[0], color[1], color[2])};
}

}  // namespace

Image panorama_of(const Sky& sky, int height, int sub) {
    Image image(2 * height, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < image.width; ++x) {
            Vec3d sum(0);
            for (int j = 0; j < sub; ++j)
                for (int i = 0; i < sub; ++i)
                    sum += sky(direction_at((x + (i + 0.5) / sub) / image.width,
                                            (y + (j + 0.5) / sub) / height));
            for (int c = 0; c < 3; ++c)
                image.row(y)[static_cast<size_t>(3 * x + c)] =
                    static_cast<float>(sum[c] / (sub * sub));
        }
    return image;
}

Vec3d lopsided_sky(const Vec3d& d) {
    const Vec3d toward_sun = normalize(Vec3d(0.55, 0.35, -0.76));
    const double sun = std::exp(60 * (dot(d, toward_sun) - 1));
    return Vec3d(0.5 + 0.45 * d.x, 0.5 + 0.45 * d.y, 0.5 + 0.45 * d.z) + sun * Vec3d(24, 18, 11);
}

Vec3d gradient_sky(const Vec3d& d) {
    const double up = smooth_step(-0.1, 1, d.y);
    const Vec3d ground(0.16, 0.13, 0.1), horizon(0.75, 0.8, 0.85), zenith(0.12, 0.27, 0.6);
    const double above = smooth_step(-0.06, 0.02, d.y);
    return (1 - above) * ground + above * ((1 - up) * horizon + up * zenith) +
           0.1 * Vec3d(1 + d.x, 1, 1 - d.x);
}

Image sun_panorama(int height) {
    Image image = panorama_of(gradient_sky, height, 2);
    const int x = image.width * 11 / 16, y = height * 5 / 16;
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i) {
            const auto pixel = image.row(y + j).subspan(static_cast<size_t>(3 * (x + i)), 3);
            pixel[0] = 1e5f;
            pixel[1] = 0.92e5f;
            pixel[2] = 0.8e5f;
        }
    return image;
}

Image one_texel_panorama(int height) {
    Image image(2 * height, height);
    const auto pixel =
        image.row(height * 3 / 8).subspan(3 * static_cast<size_t>(height * 5 / 4), 3);
    pixel[0] = 1000;
    pixel[1] = 500;
    pixel[2] = 250;
    return image;
}

Vec3d studio_sky(const Vec3d& d) {
    static const PolygonLight lights[] = {
        // A soft box, high on the right; a strip light on the left; a small kicker behind.
        {{{{0.6, 0.5, 1.0}, {1.5, 0.4, 0.5}, {1.4, 1.3, 0.3}, {0.5, 1.4, 0.8}}}, {14, 13, 12}},
        {{{{-1.0, -0.5, 0.5}, {-1.0, -0.5, 0.25}, {-1.0, 1.1, 0.2}, {-1.0, 1.2, 0.45}}},
         {7, 9, 14}},
        {{{{-0.3, 0.2, -1.0}, {0.1, 0.1, -1.0}, {0.2, 0.5, -1.0}, {-0.25, 0.55, -1.0}}},
         {30, 16, 6}},
    };
    Vec3d radiance(0.012, 0.012, 0.014);
    if (d.y < 0) radiance += -0.03 * d.y * Vec3d(1, 0.95, 0.9);
    for (const PolygonLight& light : lights)
        if (is_seen(light, d)) radiance = light.radiance;
    return radiance;
}

Vec3d night_sky(const Vec3d& d) {
    const double glow = std::exp(-6 * std::abs(d.y));
    Vec3d radiance = Vec3d(0.002, 0.003, 0.007) + glow * Vec3d(0.02, 0.012, 0.008);
    for (uint32_t i = 0; i < 24; ++i) {
        const Lamp lamp = street_lamp(i);
        // |a - b| is the angle for small angles and keeps its digits there.
        const double angle = length(d - lamp.direction);
        radiance += smooth_step(1.3, 0.9, angle / lamp.radius) * lamp.radiance;
    }
    return radiance;
}

}  // namespace splitsum::test_data
