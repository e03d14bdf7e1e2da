#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/sphere/environment.h"

namespace splitsum::tests {

/// A sky without any symmetry: red grows along +x, green along +y, blue along +z, and a small sun
/// stands off all axes. A mirrored, turned or transposed result differs from the right one.
inline Environment lopsided_sky(int height, float sun_radiance = 50) {
    Environment sky(height);
    const Vec3d sun = normalize(Vec3d(0.4, 0.5, -0.7));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < sky.width(); ++x) {
            const Vec3d d = direction_of_lat_long((x + 0.5) / sky.width(), (y + 0.5) / height);
            const float light = dot(d, sun) > 0.99 ? sun_radiance : 0.0f;
            sky.set_texel(x, y, Vec3(1.2 + d.x, 1.2 + d.y, 1.2 + d.z) + Vec3(light));
        }
    return sky;
}

/// The radiance f(direction) at every texel centre.
template <class Function>
Environment environment_of(int height, const Function& f) {
    Environment environment(height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < environment.width(); ++x)
            environment.set_texel(
                x, y,
                f(direction_of_lat_long((x + 0.5) / environment.width(), (y + 0.5) / height)));
    return environment;
}

/// The same light with its texels moved `columns` to the right.
inline Environment turned(const Environment& environment, int columns) {
    Environment result(environment.height());
    for (int y = 0; y < environment.height(); ++y)
        for (int x = 0; x < environment.width(); ++x)
            result.set_texel((x + columns) % environment.width(), y, environment.texel(x, y));
    return result;
}

}  // namespace splitsum::tests
