#include <algorithm>
#include <cmath>
#include <cstdint>

#include "skies.h"
#include "splitsum/base/random.h"

namespace splitsum::test_data {
namespace {

double smooth_step(double from, double to, double x) {
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

Vec3d blend(const Vec3d& a, const Vec3d& b, double t) { return (1 - t) * a + t * b; }

double lattice(int x, int y) {
    return unit_float(static_cast<uint32_t>(x) * 0x9e3779b9U + mix_bits(static_cast<uint32_t>(y)));
}

/// Values at the integer points, blended smoothly in between; from 0 to 1.
double value_noise(double x, double y) {
    const double fx = std::floor(x), fy = std::floor(y);
    const int ix = static_cast<int>(fx), iy = static_cast<int>(fy);
    const double tx = smooth_step(0, 1, x - fx), ty = smooth_step(0, 1, y - fy);
    const double top = lattice(ix, iy) * (1 - tx) + lattice(ix + 1, iy) * tx;
    const double bottom = lattice(ix, iy + 1) * (1 - tx) + lattice(ix + 1, iy + 1) * tx;
    return top * (1 - ty) + bottom * ty;
}

/// Octaves of value noise, each turned against the one before; from 0 to 1, 0.5 on average.
double cloud_noise(double x, double y, int octaves) {
    double sum = 0, amplitude = 0.5, total = 0;
    for (int i = 0; i < octaves; ++i) {
        sum += amplitude * value_noise(x, y);
        total += amplitude;
        const double turned = 1.6 * x - 1.2 * y + 17.3;
        y = 1.2 * x + 1.6 * y - 5.9;
        x = turned;
        amplitude *= 0.5;
    }
    return sum / total;
}

Vec3d toward_sun() { return normalize(Vec3d(0.42, 0.115, 0.9)); }

/// The air without clouds or sun disc. `d.y` >= 0.
Vec3d clear_air(const Vec3d& d) {
    const double toward = dot(d, toward_sun());
    const double height = std::max(d.y, 0.0);
    const Vec3d zenith(0.055, 0.12, 0.34), middle(0.3, 0.36, 0.55);
    const Vec3d horizon_near(2.6, 1.15, 0.38), horizon_far(0.62, 0.46, 0.56);
    const Vec3d horizon = blend(horizon_far, horizon_near, std::pow(0.5 + 0.5 * toward, 4));
    const Vec3d low = blend(horizon, middle, smooth_step(0.0, 0.42, height));
    const Vec3d air = blend(low, zenith, smooth_step(0.12, 1, height));
    const double halo = std::exp(18 * (toward - 1)), glare = std::exp(220 * (toward - 1));
    return air + halo * Vec3d(1.7, 0.8, 0.25) + glare * Vec3d(14, 8.5, 3.6);
}

/// How much of the air clouds hide, 0 to 1: a flat layer seen in perspective.
double cloud_cover(const Vec3d& d, double shift) {
    const double distance = 1 / (std::max(d.y, 0.0) + 0.07);
    const Vec3d sun = toward_sun();
    const double x = d.x * distance + shift * sun.x, z = d.z * distance + shift * sun.z;
    const double noise = cloud_noise(1.3 * x + 3.1, 2.1 * z + 8.2, 6);
    const double thinner_above = 1 - 0.7 * smooth_step(0.45, 0.95, d.y);
    return smooth_step(0.48, 0.76, noise) * smooth_step(0.0, 0.06, d.y) * thinner_above;
}

/// The sky above the horizon.
Vec3d sky_above(const Vec3d& d) {
    const double toward = dot(d, toward_sun());
    const double disc = smooth_step(0.0205, 0.0165, length(d - toward_sun()));
    const Vec3d behind = clear_air(d) + disc * Vec3d(3000, 1850, 820);
    const double cover = cloud_cover(d, 0);
    // The side of a cloud that faces the sun is lit; what is thicker towards the sun is in shadow.
    const double lit = std::clamp(0.55 + 1.6 * (cover - cloud_cover(d, 0.35)), 0.0, 1.0);
    const double near_sun = std::pow(0.5 + 0.5 * toward, 6);
    const Vec3d shadow = blend(Vec3d(0.13, 0.14, 0.22), Vec3d(0.55, 0.3, 0.26), near_sun);
    const Vec3d light = blend(Vec3d(0.85, 0.5, 0.5), Vec3d(5.2, 2.3, 0.85), near_sun);
    return blend(behind, blend(shadow, light, lit), 0.92 * cover);
}

/// Hills along the horizon: their height in an azimuth, as a sine of the elevation.
double ridge(double azimuth) {
    const double x = 1.1 * std::cos(azimuth), y = 1.1 * std::sin(azimuth);
    const double away_from_sun = 0.5 - 0.5 * std::cos(azimuth - 0.437);
    return 0.005 +
           0.15 * smooth_step(0.08, 0.75, away_from_sun) * cloud_noise(3 * x + 40, 3 * y + 7, 4);
}

/// Waves tilt the water; far ones are seen flatter.
Vec3d wave_normal(const Vec3d& d) {
    const double distance = 1.6 / (-d.y + 0.015);
    const double x = d.x * distance, z = d.z * distance;
    const double strength = 0.16 * smooth_step(0, 0.35, -d.y) + 0.035;
    const double a = cloud_noise(2.1 * x, 5.2 * z, 3) - 0.5;
    const double b = cloud_noise(2.1 * x + 31.7, 5.2 * z - 11.4, 3) - 0.5;
    return normalize(Vec3d(strength * a, 1, 2 * strength * b));
}

/// The sea: the sky mirrored by waves, more of it the flatter it is seen (Schlick 1994, F0 = 0.02).
Vec3d sea(const Vec3d& d) {
    const Vec3d n = wave_normal(d);
    const double cosine = std::max(-dot(d, n), 0.0);
    Vec3d mirrored = d + 2 * cosine * n;
    mirrored.y = std::abs(mirrored.y);
    const double fresnel = 0.02 + 0.98 * std::pow(1 - cosine, 5);
    // The disc itself would sparkle texel by texel: a wide lobe stands for it.
    const double glitter = std::exp(90 * (dot(normalize(mirrored), toward_sun()) - 1));
    const Vec3d light = clear_air(normalize(mirrored)) + glitter * Vec3d(26, 14, 5);
    return Vec3d(0.02, 0.055, 0.075) + fresnel * light;
}

}  // namespace

Vec3d sunset_sky(const Vec3d& d) {
    const double top = ridge(std::atan2(d.x, d.z));
    if (d.y > top) return sky_above(d);
    if (d.y > 0) {
        const double haze = smooth_step(0.0, 0.16, top - d.y);
        const double toward = 0.5 + 0.5 * dot(d, toward_sun());
        return blend(Vec3d(0.22, 0.19, 0.24), Vec3d(0.045, 0.05, 0.06), 0.4 + 0.6 * haze) *
               (0.7 + toward);
    }
    return sea(d);
}

}  // namespace splitsum::test_data
