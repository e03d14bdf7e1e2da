#pragma once

#include <memory>
#include <span>
#include <vector>

#include "splitsum/filter/methods.h"
#include "splitsum/preview/scene.h"
#include "splitsum/preview/sphere_surfaces.h"

namespace splitsum {

/// The two kinds of prefiltered light that the split sum asks for at a point of a surface.
struct SplitLight {
    Vec3 specular{0};
    Vec3 irradiance_over_pi{0};

    Vec3 seen_on(const Surface& surface) const {
        return Vec3(image_based_light(Vec3d(specular), Vec3d(irradiance_over_pi),
                                      surface.response.reflectance,
                                      surface.response.diffuse_albedo));
    }
};

/// Light filtered for the materials of a scene, at any direction: what a chain of endlessly many
/// texels with a level for each material would hold. By `spectral`, asked for 1e-5 of the whole,
/// which it may miss under a sun of one texel; `auto` would then fall back to `reference`, minutes
/// a sphere.
class ExactLight {
public:
    /// `environment` must outlive it.
    ExactLight(const Environment& environment, const Scene& scene);

    /// At points of surfaces of one roughness.
    std::vector<SplitLight> at(std::span<const Surface> surfaces) const;

private:
    std::vector<Vec3> filtered(const Lobe& lobe, const std::vector<Vec3d>& towards) const;

    const Environment& environment_;
    std::vector<double> alphas_;  // of the lobes that are filtered, after the cosine
    std::unique_ptr<PreparedFilter> filter_;
};

/// The same by fp64 integration over every texel (`reference`), one point after the other.
Result<std::vector<SplitLight>> reference_light(const Environment& environment,
                                                std::span<const Surface> surfaces,
                                                Progress& progress);

}  // namespace splitsum
