#include "splitsum/preview/sphere_surfaces.h"

#include <map>

namespace splitsum {

SphereSurfaces::SphereSurfaces(const Scene& scene, const Mat3d& panorama_from_cube)
    : scene_(scene), panorama_from_cube_(panorama_from_cube) {
    std::map<double, std::shared_ptr<const ViewSplitSum>> by_alpha;
    for (const Sphere& sphere : scene.spheres) {
        auto& shared = by_alpha[alpha_of(sphere.material)];
        if (!shared) shared = std::make_shared<const ViewSplitSum>(alpha_of(sphere.material));
        split_sums_.push_back(shared);
    }
}

Surface SphereSurfaces::at(const SeenSurface& seen) const {
    const size_t sphere = size_t(seen.sphere);
    return surface_of(scene_.spheres[sphere].material, *split_sums_[sphere],
                      panorama_from_cube_ * seen.normal, panorama_from_cube_ * seen.view);
}

}  // namespace splitsum
