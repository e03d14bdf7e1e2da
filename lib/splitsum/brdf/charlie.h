#pragma once

#include <span>
#include <string_view>

namespace splitsum {

/// Cloth: Estevez & Kulla 2017, "Production Friendly Microfacet Sheen BRDF", SIGGRAPH course. Facets
/// stand up like fibres, so light that grazes comes back, and the smoother the cloth the nearer to
/// the horizon.
///
/// The distribution of facet normals ("Charlie") per steradian:
///     D(h) = (2 + 1 / alpha) sin(theta_h)^(1 / alpha) / (2 pi)
/// `sin2_theta` in [0, 1], `alpha` in (0, 1]: perceptual roughness squared, as in KHR_materials_sheen
/// and Filament. D cos theta integrates to 1 over the hemisphere.
double charlie_density(double sin2_theta, double alpha);

/// Shadowing and masking of cloth, always as the visibility V = G / (4 n·l n·v).
enum class ClothVisibility {
    neubelt,          ///< 1 / (4 (n·l + n·v - n·l n·v)), Neubelt & Pettineo 2013
    neubelt_clamped,  ///< the same, at most 1
    estevez_kulla,    ///< 1 / (4 n·l n·v (1 + Lambda(l) + Lambda(v))), the fit of the paper
};

struct ClothVisibilityInfo {
    ClothVisibility visibility;
    std::string_view name;
    std::string_view summary;
};

/// Every term; the first is the default: the one of Filament's and Khronos' tables.
std::span<const ClothVisibilityInfo> cloth_visibilities();

/// V for cosines in (0, 1]; `alpha` in (0, 1]. Reciprocal.
double cloth_visibility(ClothVisibility visibility, double n_dot_l, double n_dot_v, double alpha);

/// Lambda of the paper's Smith term, a fit to the integral over D; without the softened terminator of
/// its section 4, which is not reciprocal. `cosine` in (0, 1], `alpha` in [0, 1].
double charlie_lambda(double cosine, double alpha);

}  // namespace splitsum
