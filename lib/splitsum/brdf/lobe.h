#pragma once

#include <string_view>

namespace splitsum {

/// Shapes of lobes about a direction R that a level can be filtered with.
enum class LobeKind {
    ggx,     ///< reflection of a GGX surface seen along its normal (n = v = R; Karis 2013)
    cosine,  ///< clamped cosine: diffuse irradiance divided by pi
};

/// A zonal lobe: its value depends on the angle to R alone, so filtering with it scales every
/// spherical-harmonic band by one number (Funk-Hecke).
struct Lobe {
    LobeKind kind = LobeKind::ggx;
    double alpha = 1;  ///< GGX width, perceptual roughness squared, in [0, 1]; 0 is the mirror
};

/// The lobe's value, not normalised, for a direction l whose cosine with R is 1 - `versine`:
/// GGX: D(h) max(c, 0) with theta_h = theta_l / 2, D normalised so that D(0) = 1 / (pi alpha²);
/// cosine: max(c, 0). The versine |l - R|² / 2 keeps its digits where 1 - c would cancel (tiny
/// alpha). `versine` is in [0, 2]; alpha > 0.
inline double lobe_value(const Lobe& lobe, double versine) {
    const double cosine = 1 - versine;
    if (cosine <= 0) return 0;
    if (lobe.kind == LobeKind::cosine) return cosine;
    // D = alpha² / (pi (cos² alpha² + sin²)²) with sin² = versine / 2 (Walter et al. 2007, eq. 33).
    const double sin2 = 0.5 * versine;
    const double alpha2 = lobe.alpha * lobe.alpha;
    const double denominator = (1 - sin2) * alpha2 + sin2;
    return cosine * alpha2 / (3.141592653589793 * denominator * denominator);
}

/// The angle in radians over which the lobe changes by a factor of order 1: the distance of its
/// nearest complex poles for GGX (tan theta_h = +-i alpha, so about 2 alpha), 1 for the cosine.
inline double lobe_width(const Lobe& lobe) {
    return lobe.kind == LobeKind::ggx ? 2 * lobe.alpha : 1.0;
}

/// ∫ K dl over the directions within `radius` radians of the peak, at most pi / 2, beyond which K
/// is 0. Gauss-Legendre on panels that grow from the peak, to 1e-14 relatively (tested against
/// closed forms). alpha > 0. Cost: about a thousand evaluations.
double lobe_integral_within(const Lobe& lobe, double radius);

/// ∫ K dl over the sphere, what a lobe's values are divided by; pi for the cosine.
double lobe_integral(const Lobe& lobe);

}  // namespace splitsum
