#pragma once

#include <span>
#include <vector>

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/brdf/lobe.h"
#include "splitsum/filter/reference_probes.h"
#include "splitsum/sphere/environment.h"
#include "splitsum/verify/probe_texels.h"
#include "splitsum/verify/texel_means.h"

namespace splitsum {

/// A cubemap that will be measured. A GGX lobe of alpha 0 is the mirror image.
struct ProbedCubemap {
    Lobe lobe;
    int face_size;
};

/// What some texels of a cubemap are by exact integration of its panorama.
struct ExactTexels {
    int face_size = 0;
    std::vector<ProbeTexel> texels;
    std::vector<Vec3> radiance;
};

/// Exact integration for a few texels of every cubemap, while the panorama's rows pass by: by
/// `reference`, and of mirror images by the mean over the texel.
class ExactProbes {
public:
    /// `probes` texels of each cubemap, chosen by probe_texels, of a panorama of `height` rows.
    ExactProbes(int height, const Mat3d& panorama_from_cube,
                std::span<const ProbedCubemap> cubemaps, int probes);

    /// How many texels there are in all: adding rows takes time in proportion.
    int texel_count() const { return int(reference_of_.size() + mean_of_.size()); }

    /// The next rows, from the top down; of the floats of a texel (3 or 4) the first three are its
    /// radiance. The bits do not depend on how many rows come at a time, nor on the threads.
    void add_rows(int row_count, const float* texels, int floats_per_texel);

    /// For each cubemap, when every row was added.
    std::vector<ExactTexels> finish() &&;

private:
    // Texel `texel` of cubemap `cubemap`.
    struct Place {
        size_t cubemap;
        size_t texel;
    };

    std::vector<ExactTexels> exact_;
    std::vector<Place> reference_of_;
    std::vector<Place> mean_of_;
    ReferenceProbes reference_;
    TexelMeans means_;
};

/// The same for a panorama in memory. Progress: the stage "measuring", one step a texel. Fails only
/// when cancelled.
Result<std::vector<ExactTexels>> exact_texels(const Environment& environment,
                                              const Mat3d& panorama_from_cube,
                                              std::span<const ProbedCubemap> cubemaps, int probes,
                                              Progress& progress);

}  // namespace splitsum
