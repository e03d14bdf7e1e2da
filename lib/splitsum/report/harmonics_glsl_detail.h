#pragma once

#include <string>

#include "splitsum/filter/irradiance_harmonics.h"

namespace splitsum {

/// The highest band that harmonics_glsl can write out.
inline constexpr int highest_glsl_order = 4;

/// A GLSL function `vec3 splitsum_irradiance(vec3 n)` that returns E / pi for the unit normal n in
/// the cube's axes. The constants of the basis are folded into the coefficients.
std::string harmonics_glsl(const IrradianceHarmonics& harmonics);

}  // namespace splitsum
