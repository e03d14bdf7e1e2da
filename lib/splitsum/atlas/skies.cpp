#include "splitsum/atlas/skies.h"

#include <algorithm>

#include "splitsum/base/random.h"
#include "splitsum/sphere/cubemap.h"

namespace splitsum {
namespace {

template <class Radiance>
Environment environment_of(int rows, const Radiance& radiance) {
    Environment sky(rows);
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < sky.width(); ++x)
            sky.set_texel(
                x, y, radiance(direction_of_lat_long((x + 0.5) / sky.width(), (y + 0.5) / rows)));
    return sky;
}

void light_texel(Environment& sky, const Vec3d& direction, const Vec3& radiance) {
    const LatLong at = lat_long_towards(direction);
    sky.set_texel(std::min(static_cast<int>(at.u * sky.width()), sky.width() - 1),
                  std::min(static_cast<int>(at.v * sky.height()), sky.height() - 1), radiance);
}

Environment dim_sky(int rows) {
    return environment_of(rows, [](const Vec3d&) { return Vec3(0.1f, 0.2f, 0.3f); });
}

Vec3 gradient(const Vec3d& direction) { return Vec3(Vec3d(1.2) + direction); }

}  // namespace

Environment gradient_sky(int rows) { return environment_of(rows, gradient); }

Environment sun_sky(int rows, float radiance) {
    Environment sky = dim_sky(rows);
    light_texel(sky, direction_of_texel(1, 5, 2, 8), radiance * Vec3(1, 0.7f, 0.3f));
    return sky;
}

Environment two_suns_sky(int rows) {
    Environment sky = sun_sky(rows, 1e5f);
    light_texel(sky, direction_of_texel(4, 1, 5, 8), Vec3(3e3f, 7e3f, 1e4f));
    return sky;
}

Environment sun_at_pole_sky(int rows) {
    Environment sky = dim_sky(rows);
    sky.set_texel(sky.width() / 5, 0, Vec3(1e5f, 7e4f, 3e4f));
    return sky;
}

Environment lit_poles_sky(int rows) {
    Environment sky = gradient_sky(rows);
    for (int x = 0; x < sky.width(); ++x) {
        sky.set_texel(x, 0, Vec3(100, 80, 60));
        sky.set_texel(x, rows - 1, Vec3(60, 80, 100));
    }
    return sky;
}

Environment lit_edge_sky(int rows) {
    Environment sky = gradient_sky(rows);
    const int x = sky.width() / 2 + sky.width() / 8;  // the column right of azimuth 45 degrees
    for (int y = rows / 4; y < rows * 2 / 3; ++y) sky.set_texel(x, y, Vec3(100, 60, 80));
    return sky;
}

Environment checkerboard_sky(int rows) {
    Environment sky(rows);
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < sky.width(); ++x)
            sky.set_texel(x, y, (x + y) % 2 == 0 ? Vec3(2, 1.5f, 1) : Vec3(0.1f, 0.2f, 0.4f));
    return sky;
}

Environment one_texel_sky(int rows) {
    Environment sky(rows);
    light_texel(sky, direction_of_texel(1, 5, 2, 8), Vec3(1, 1, 1));
    return sky;
}

Environment constant_sky(int rows) {
    return environment_of(rows, [](const Vec3d&) { return Vec3(0.7f, 3.0f, 1e4f); });
}

Environment night_sky(int rows) {
    Environment sky =
        environment_of(rows, [](const Vec3d& direction) { return 0.005f * gradient(direction); });
    for (uint32_t lamp = 0; lamp < 40; ++lamp) {
        const auto number = [&](uint32_t use) { return unit_float(8 * lamp + use); };
        const Vec3 colour(0.5f + 0.5f * number(0), 0.3f + 0.5f * number(1),
                          0.1f + 0.9f * number(2));
        const float radiance = 10 * std::pow(200.0f, number(3));
        light_texel(sky,
                    direction_of_lat_long(static_cast<double>(number(4)),
                                          0.4 + 0.3 * static_cast<double>(number(5))),
                    radiance * colour);
    }
    return sky;
}

Environment overflowing_sky(int rows) {
    Environment sky = dim_sky(rows);
    for (int i = 0; i < 3; ++i)
        sky.set_texel(sky.width() / 3 + i, rows / 2, Vec3(3e5f, 2e5f, 1e5f));
    return sky;
}

}  // namespace splitsum
