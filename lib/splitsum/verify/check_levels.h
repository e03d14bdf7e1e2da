#pragma once

#include <span>
#include <vector>

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/filter/irradiance_harmonics.h"
#include "splitsum/measure/error_figures.h"
#include "splitsum/sphere/cubemap.h"
#include "splitsum/sphere/environment.h"
#include "splitsum/verify/exact_probes.h"

namespace splitsum {

/// A level beside the exact integral of the panorama it was made from.
struct LevelCheck {
    int level = 0;
    int face_size = 0;
    double perceptual_roughness = 0;  ///< 1 for diffuse light, which is the widest lobe
    ErrorFigures figures;             ///< at the probe texels; of 0 texels if there were none
    Vec3d mean_radiance{0};           ///< over the whole level
};

/// Texels a level that a bake measures unless it is told: few, so that measuring takes a tenth of
/// the time of a bake. 8, or 1 of panoramas of more than 1024 rows, where reading is most of the work.
int default_probes(int panorama_height);

/// How the stored texels relate to the panorama.
struct CheckedAgainst {
    const Environment& environment;
    Mat3d panorama_from_cube;
    /// Texels compared a level, spread evenly; all of them when there are fewer, none if 0.
    int probes = 64;
};

/// Compares a cubemap with what its texels would be by exact integration; `exact` may be of no
/// texels. The cubemap's light is divided by `stored_factor` before.
LevelCheck check_level(const Cubemap& cubemap, const ExactTexels& exact, double stored_factor = 1);

/// The same of diffuse light, whose lobe is the widest: its perceptual roughness is stated as 1.
LevelCheck check_diffuse(const Cubemap& cubemap, const ExactTexels& exact,
                         double stored_factor = 1);

/// Compares each level of a prefiltered chain with `exact`, of one cubemap a level or of none at
/// all; levels[l] has perceptual_roughness[l].
std::vector<LevelCheck> check_chain(std::span<const Cubemap> levels,
                                    std::span<const double> perceptual_roughness,
                                    std::span<const ExactTexels> exact);

/// Compares each level of a prefiltered chain with `reference` at the probes; levels[l] has
/// roughness[l]. A level of roughness 0 is compared with the mean of the panorama over each texel,
/// taken at 128² points. Cost: about 1.3 ms a probe of a 1024 x 512 panorama on one core.
/// Fails only when cancelled.
Result<std::vector<LevelCheck>> check_specular(std::span<const Cubemap> levels,
                                               std::span<const double> perceptual_roughness,
                                               const CheckedAgainst& truth, Progress& progress);

/// Compares a cubemap of E / pi (times `stored_factor`: pi where E itself is stored).
Result<LevelCheck> check_irradiance(const Cubemap& irradiance, double stored_factor,
                                    const CheckedAgainst& truth, Progress& progress);

/// Texels along an edge at which harmonics are checked.
inline constexpr int harmonics_face_size = 16;

/// A cubemap of what a renderer evaluates from the harmonics, to be checked like irradiance: the
/// figure is the price of the short series, not of how it was computed.
Cubemap cubemap_of_harmonics(const IrradianceHarmonics& harmonics,
                             int face_size = harmonics_face_size);

/// Compares cubemap_of_harmonics with exact irradiance.
Result<LevelCheck> check_harmonics(const IrradianceHarmonics& harmonics,
                                   const CheckedAgainst& truth, Progress& progress);

/// The levels of a prefiltered chain, to be measured.
std::vector<ProbedCubemap> probed_chain(int face_size,
                                        std::span<const double> perceptual_roughness);

}  // namespace splitsum
