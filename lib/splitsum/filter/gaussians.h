#pragma once

#include <vector>

#include "splitsum/filter/filter_source.h"
#include "splitsum/math/vec.h"

namespace splitsum {

/// Light as a sum of lobes a exp(sharpness (axis·l - 1)), spherical Gaussians (Tsai & Shih 2006,
/// "All-Frequency Precomputed Radiance Transfer using Spherical Radial Basis Functions"). No
/// amplitude is negative, so no direction ever is, which short series of harmonics cannot promise.
struct SphericalGaussians {
    double sharpness = 0;           ///< of every lobe
    std::vector<Vec3d> axes;        ///< unit; spread evenly
    std::vector<Vec3d> amplitudes;  ///< radiance at the axis, >= 0
};

/// Counts that fit_gaussians is made and measured for.
inline constexpr int fewest_gaussians = 6;
inline constexpr int most_gaussians = 24;

/// `count` lobes, from fewest_gaussians to most_gaussians, whose irradiance_over_pi is closest to
/// that of the light in the mean square over the sphere. Axes lie on a spherical Fibonacci lattice
/// (Swinbank & Purser 2006, "Fibonacci Grids") in the cube's axes, and with the sharpness depend on
/// the count alone; amplitudes are non-negative least squares for each channel.
///
/// Integrals are exact up to the bands that a cosine leaves of either side: in harmonic space both
/// the light (filter/harmonics_of_environment.h) and what a lobe is read as are zonal products, so
/// what is fitted is what irradiance_over_pi returns, its own error included.
///
/// Measured rel_rms of E / pi with 6, 12 and 24 lobes: overcast 0.035, 0.005, 0.002; a sunset
/// 0.17, 0.015, 0.004; a studio of soft boxes 0.22, 0.14, 0.065, where nine harmonics that must not
/// be negative either have 0.071. Cost: a transform of 17 bands, 40 ms for 1024 x 512.
SphericalGaussians fit_gaussians(const FilterSource& source, int count,
                                 const Mat3d& panorama_from_cube = Mat3d(1));

/// E(normal) / pi of the lobes, in closed form.
Vec3d irradiance_over_pi(const SphericalGaussians& gaussians, const Vec3d& normal);

/// E / pi of a lobe of amplitude 1 on a normal at this cosine from its axis. Both ends, cosine 1
/// and -1, are exact; the ramp between them is Hill's (in Pettineo 2016, "SG Series Part 3: Diffuse
/// Lighting From an SG Light Source"): the clamped cosine, rounded by a parabola. Absolute error
/// at most 1.2 % of the value at cosine 1, for sharpness 1 to 64 (tested).
double gaussian_irradiance_over_pi(double sharpness, double cosine);

}  // namespace splitsum
