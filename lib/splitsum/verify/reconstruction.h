#pragma once

#include <span>
#include <vector>

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/filter/reference_probes.h"
#include "splitsum/math/vec.h"
#include "splitsum/measure/error_figures.h"
#include "splitsum/plan/roughness_curve.h"
#include "splitsum/sphere/cubemap.h"
#include "splitsum/sphere/environment.h"

namespace splitsum {

/// A range of perceptual roughness, from < to, in [0, 1].
struct RoughnessBand {
    double from;
    double to;
};

/// [0, 1/8], [1/8, 1/4], [1/4, 1/2], [1/2, 1]: lobes of about the same number of widths each.
std::span<const RoughnessBand> roughness_bands();

/// What an engine should have read, at points that know nothing of texels and levels.
struct ReconstructionProbes {
    struct Probe {
        Vec3d towards;                ///< in cube space, unit length
        double perceptual_roughness;  ///< strictly inside the band
        Vec3 exact;                   ///< the exact integral there
    };
    struct Band {
        RoughnessBand range;
        std::vector<Probe> probes;
    };
    std::vector<Band> bands;
};

/// Exact integration for the probes while the panorama's rows pass by.
class ReconstructionRows {
public:
    /// `count` probes in each band of a panorama of `height` rows: directions evenly over the
    /// sphere, roughness evenly over the band (points of an additive sequence; Roberts 2018, "The
    /// Unreasonable Effectiveness of Quasirandom Sequences", R3), the first n of them the same for
    /// every count. Deterministic.
    ReconstructionRows(int height, const Mat3d& panorama_from_cube,
                       std::span<const RoughnessBand> bands, int count);

    int probe_count() const { return int(bands_.size()) * count_; }

    /// The next rows, as ReferenceProbes takes them, and at its cost.
    void add_rows(int row_count, const float* texels, int floats_per_texel) {
        reference_.add_rows(row_count, texels, floats_per_texel);
    }

    /// When every row was added.
    ReconstructionProbes finish() &&;

private:
    std::vector<ReconstructionProbes::Band> bands_;
    int count_;
    ReferenceProbes reference_;
};

/// The same for a panorama in memory. Progress: the stage "measuring", one step a probe. Cost:
/// about 1 ms a probe of a 1024 x 512 panorama on one core. Fails only when cancelled.
Result<ReconstructionProbes> reconstruction_probes(const Environment& environment,
                                                   const Mat3d& panorama_from_cube,
                                                   std::span<const RoughnessBand> bands, int count,
                                                   Progress& progress);

/// What an engine reads from a chain: seamless bilinear lookups in the two levels around
/// level_of_roughness(curve), blended linearly. `direction` has any length but 0.
Vec3 trilinear_lookup(std::span<const Cubemap> levels, const RoughnessCurve& curve,
                      const Vec3d& direction, double perceptual_roughness);

struct ReconstructionError {
    RoughnessBand range;
    ErrorFigures figures;  ///< of what is read against the exact integral
};

/// How far an engine's lookups in `levels` (as decoded from the stored format) are from the exact
/// integral: the price of texels, levels and format together, band by band. Says whether size and
/// number of levels are enough for this light. Costs next to nothing once there are probes.
std::vector<ReconstructionError> reconstruction_error(std::span<const Cubemap> levels,
                                                      const RoughnessCurve& curve,
                                                      const ReconstructionProbes& probes);

}  // namespace splitsum
