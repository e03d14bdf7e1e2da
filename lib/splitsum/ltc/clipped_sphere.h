#pragma once

namespace splitsum {

/// The share of a sphere's form factor that the horizon leaves: what the fourth channel of the second
/// LTC layer holds. Engines that do not clip polygons take the length of a polygon's vector form
/// factor for that of a sphere, sin² of its angular radius, and its direction for the sphere's
/// (Hill & Heitz 2016, "Real-Time Area Lighting: a Journey from Research to Production", SIGGRAPH
/// course).
///
/// `cos_to_centre` in [-1, 1] is the cosine from the normal to the sphere's centre, `form_factor` in
/// [0, 1] that of the sphere facing the normal. The result is (clipped form factor) / `form_factor`,
/// in [0, 1]; its limit max(cos_to_centre, 0) at 0, and (1 + cos_to_centre) / 2 at 1, half of the
/// sky. Absolute error below 1e-9.
double clipped_sphere_ratio(double cos_to_centre, double form_factor);

}  // namespace splitsum
