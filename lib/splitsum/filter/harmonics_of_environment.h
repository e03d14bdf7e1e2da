#pragma once

#include <vector>

#include "splitsum/filter/filter_source.h"
#include "splitsum/math/vec.h"
#include "splitsum/sphere/environment.h"

namespace splitsum {

/// The radiance as spherical-harmonic coefficients f_lm = ∫ L Y_lm dl of bands 0 .. order, in the
/// basis of math/harmonics.h about the cube's own axes (+z is the basis' pole). `panorama_from_cube`
/// is orthogonal.
///
/// Exact for the piecewise-constant environment: closed form over each texel's azimuths, enough
/// Gauss points over its polar angles that 1e-12 is left. Cost: texels * (order + 1) operations.
std::vector<Vec3d> harmonics_of_environment(const Environment& environment, int order,
                                            const Mat3d& panorama_from_cube);

/// The same from the source's spectrum where it has one with enough bands: one transform serves
/// everything.
std::vector<Vec3d> harmonics_of(const FilterSource& source, int order,
                                const Mat3d& panorama_from_cube);

}  // namespace splitsum
