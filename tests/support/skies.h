#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <string_view>

#include "splitsum/sphere/environment.h"
#include "support/lopsided_sky.h"

namespace splitsum::tests {

/// A kind of light that some way of filtering finds hard, at any resolution; none has a symmetry.
struct NamedSky {
    std::string_view name;
    Environment (*make)(int height);
};

/// Clouds that hide the sun: bright above, darker below, with soft blotches of a few bands.
inline Environment overcast_sky(int height) {
    return environment_of(height, [](const Vec3d& d) {
        const double blotches =
            0.15 * std::sin(5 * d.x + 2 * d.y + 1) * std::sin(4 * d.z - 3 * d.x);
        const double light = 0.6 + 0.5 * d.y + 0.1 * d.x + blotches;
        return Vec3(Vec3d(0.90, 0.95, 1.05) * light);
    });
}

/// A gradient, a dark ground and a sun of radiance 1e5 and half a degree in radius, just large
/// enough that a panorama of 256 rows has a texel centre in it.
inline Environment sunset_sky(int height) {
    const Vec3d sun = direction_of_lat_long(0.31, 0.46);
    const double sun_chord = 2 * std::sin(0.5 * 0.5 * std::numbers::pi / 180);
    return environment_of(height, [=](const Vec3d& d) {
        const double glow = std::exp(4 * (dot(d, sun) - 1));
        const Vec3d sky = d.y > 0 ? Vec3d(0.15, 0.22, 0.4) + Vec3d(1.5, 0.7, 0.2) * glow
                                  : Vec3d(0.06, 0.05, 0.04) * (1 + glow);
        const Vec3d disc = length(d - sun) < sun_chord ? Vec3d(1e5, 6e4, 2e4) : Vec3d(0);
        return Vec3(sky + disc);
    });
}

/// A rectangle of light seen from the origin: centre and half axes in units of the distance.
struct SoftBox {
    Vec3d centre, half_width, half_height;
    double radiance;

    bool covers(const Vec3d& direction) const {
        const Vec3d normal = cross(half_width, half_height);
        const double along = dot(direction, normal), distance = dot(centre, normal);
        if (along * distance <= 0) return false;
        const Vec3d offset = direction * (distance / along) - centre;
        return std::abs(dot(offset, half_width)) < dot(half_width, half_width) &&
               std::abs(dot(offset, half_height)) < dot(half_height, half_height);
    }
};

/// A nearly black room with three soft boxes of different sizes and heights.
inline Environment studio_sky(int height) {
    static const std::array<SoftBox, 3> boxes = {
        {{{1.0, 0.4, 0.2}, {-0.1, 0, 0.5}, {0, 0.3, 0}, 30},
         {{-0.3, 1.0, 0.5}, {0.25, 0, 0}, {0, 0, 0.15}, 60},
         {{-0.8, -0.1, -0.9}, {0.09, 0, -0.08}, {0, 0.6, 0}, 12}}};
    return environment_of(height, [](const Vec3d& d) {
        Vec3d light = Vec3d(0.02, 0.021, 0.023) * (1.5 + d.x + 0.3 * d.z);
        for (const SoftBox& box : boxes)
            if (box.covers(d)) light += Vec3d(1.0, 0.97, 0.92) * box.radiance;
        return Vec3(light);
    });
}

/// Every sky, the easiest first.
inline std::span<const NamedSky> skies() {
    static constexpr std::array<NamedSky, 4> all = {
        {{"overcast", overcast_sky},
         {"lopsided", [](int height) { return lopsided_sky(height); }},
         {"studio", studio_sky},
         {"sunset", sunset_sky}}};
    return all;
}

}  // namespace splitsum::tests
