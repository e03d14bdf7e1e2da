#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "splitsum/base/result.h"
#include "splitsum/plan/roughness_curve.h"
#include "splitsum/plan/sampling_plan.h"
#include "splitsum/plan/table_plan.h"
#include "splitsum/sphere/orientation.h"

namespace splitsum {

/// How hard a filter works, whatever it filters.
struct FilterPlan {
    std::string method = "auto";  ///< a name from filter_methods()
    int samples = 1024;           ///< directions per texel; of the sampling methods
    double accuracy = 3e-4;  ///< rel_rms by which `auto` and `spectral` may miss, in [1e-5, 0.1]
    bool rotate_samples = false;  ///< turn the sample set by an angle hashed from the texel
    uint32_t seed = 0;  ///< of everything drawn from a texel's key; change it to see the noise
    PointSequence sequence = PointSequence::hammersley;  ///< of the methods that draw points
    MisHeuristic heuristic = MisHeuristic::power;        ///< of `mis`
};

/// The prefiltered chain: reading level l towards R gives the radiance that a mirror of that
/// level's roughness reflects towards a viewer at R.
struct SpecularPlan {
    int face_size = 256;  ///< texels along an edge of level 0, in [1, 8192]
    int levels = 7;
    RoughnessCurve roughness;
};

/// Diffuse light: reading towards a normal n gives E(n) / pi.
struct IrradiancePlan {
    int face_size = 32;
    int harmonics_order = 2;        ///< highest band; order 2 has 9 coefficients
    bool windowed = false;          ///< scale the bands so that a sun rings less (Sloan 2008)
    bool store_irradiance = false;  ///< store E itself instead of E / pi
};

/// Fail with bad_argument: what was asked, and what would work.
Status validate(const FilterPlan& plan);
Status validate(const SpecularPlan& plan);
Status validate(const IrradiancePlan& plan);

}  // namespace splitsum
