#pragma once

#include <optional>
#include <span>
#include <vector>

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/filter/irradiance_harmonics.h"
#include "splitsum/measure/error_figures.h"
#include "splitsum/sphere/cubemap.h"
#include "splitsum/sphere/environment.h"

namespace splitsum {

/// A level beside the exact integral of the panorama it was made from.
struct LevelCheck {
    int level = 0;
    int face_size = 0;
    double perceptual_roughness = 0;  ///< 1 for diffuse light, which is the widest lobe
    ErrorFigures figures;             ///< at the probe texels; of 0 texels if there were none
    Vec3d mean_radiance{0};           ///< over the whole level
};

/// How many probes a level a bake can spend: 64 for panoramas of up to 512 rows, for larger ones
/// fewer, so that measuring takes no longer, but at least 4.
int affordable_probes(const Environment& environment);

/// How the stored texels relate to the panorama.
struct CheckedAgainst {
    const Environment& environment;
    Mat3d panorama_from_cube;
    /// Texels compared a level, spread evenly; all of them when there are fewer, none if 0.
    int probes = 64;
};

/// Compares each level of a prefiltered chain with `reference` at the probes; levels[l] has
/// roughness[l]. A level of roughness 0 is compared with the mean of the panorama over each texel,
/// taken at 128 x 128 points. Cost: about 1 ms a probe of a 1024 x 512 panorama on one core.
/// Fails only when cancelled.
Result<std::vector<LevelCheck>> check_specular(std::span<const Cubemap> levels,
                                               std::span<const double> perceptual_roughness,
                                               const CheckedAgainst& truth, Progress& progress);

/// Compares a cubemap of E / pi (times `stored_factor`: pi where E itself is stored).
Result<LevelCheck> check_irradiance(const Cubemap& irradiance, double stored_factor,
                                    const CheckedAgainst& truth, Progress& progress);

/// Compares what a renderer evaluates from the harmonics with exact irradiance: the figure is the
/// price of the short series, not of how it was computed.
Result<LevelCheck> check_harmonics(const IrradianceHarmonics& harmonics,
                                   const CheckedAgainst& truth, Progress& progress);

}  // namespace splitsum
