#pragma once

namespace splitsum {

/// Which diffuse lobe of Disney's principled material.
enum class DisneyDiffuse {
    burley,        ///< Burley 2012, "Physically-Based Shading at Disney", 5.3
    renormalised,  ///< Lagarde & de Rousiers 2014, "Moving Frostbite to PBR", listing 2
};

/// The lobe per steradian for an albedo of 1, to be multiplied with n·l:
///     factor / pi (1 + (F90 - 1) (1 - n·l)^5) (1 + (F90 - 1) (1 - n·v)^5),
///     F90 = bias + 2 r cos² theta_d,   cos² theta_d = (1 + l·v) / 2,
/// with bias = 1/2 and factor = 1 (burley), or bias = r / 2 and factor = 1 + r (1 / 1.51 - 1)
/// (renormalised). Reciprocal. The cosines `n_dot_l` and `n_dot_v` in [0, 1], `l_dot_v` in [-1, 1],
/// perceptual roughness r in [0, 1].
double disney_diffuse(DisneyDiffuse lobe, double n_dot_l, double n_dot_v, double l_dot_v,
                      double perceptual_roughness);

/// The directional albedo ∫ lobe n·l dl over the hemisphere. F90 is linear in l·v, so the azimuth
/// goes in closed form and what is left is a polynomial in n·l of degree 17 or less, which 9
/// Gauss-Legendre nodes integrate exactly: error below 1e-14. Up to 1.558 for burley, at grazing
/// views of rough surfaces; up to 1.032 there for renormalised, whose 1.51 falls that short, and
/// below 1 elsewhere. Cost: about 0.1 µs.
double disney_diffuse_albedo(DisneyDiffuse lobe, double n_dot_v, double perceptual_roughness);

}  // namespace splitsum
