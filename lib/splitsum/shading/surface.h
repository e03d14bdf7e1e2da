#pragma once

#include "splitsum/math/vec.h"
#include "splitsum/table/split_sum_lookup.h"

namespace splitsum {

// A surface of metalness and perceptual roughness (glTF 2.0, appendix B) under baked light: the twin
// of shaders/include/splitsum_surface.glsl. Colours are scene-linear.

/// Reflectance at normal incidence of everything that is no metal, for an index of refraction of 1.5.
inline constexpr double dielectric_f0 = 0.04;

/// Reflectance at normal incidence, F0. `base_color` and `metalness` in [0, 1].
inline Vec3d f0_of(const Vec3d& base_color, double metalness) {
    return (1 - metalness) * Vec3d(dielectric_f0) + metalness * base_color;
}

/// The albedo of what lies below the reflecting surface: what it reflects does not get there, and
/// metals have nothing below. `reflectance`: of split_sum_lookup.h, channel by channel.
inline Vec3d diffuse_albedo_of(const Vec3d& base_color, double metalness,
                               const Vec3d& reflectance) {
    return (1 - metalness) * base_color * (Vec3d(1) - reflectance);
}

/// What a surface does with light, per channel.
struct SurfaceResponse {
    Vec3d f0;
    Vec3d compensation;    ///< of light that is reflected once, for later bounces
    Vec3d reflectance;     ///< of uniform light, all bounces
    Vec3d diffuse_albedo;  ///< of what lies below
};

/// `split_sum`: as the table holds it for the view and the roughness.
SurfaceResponse response_of(const Vec3d& base_color, double metalness, const SplitSum& split_sum);

/// Radiance towards the viewer under an environment: `specular_light` as the specular cubemap holds
/// it, `irradiance_over_pi` as the irradiance cubemap or the harmonics hold it.
inline Vec3d image_based_light(const Vec3d& specular_light, const Vec3d& irradiance_over_pi,
                               const Vec3d& reflectance, const Vec3d& diffuse_albedo) {
    return specular_light * reflectance + irradiance_over_pi * diffuse_albedo;
}

}  // namespace splitsum
