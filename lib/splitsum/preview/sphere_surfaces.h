#pragma once

#include <memory>
#include <vector>

#include "splitsum/preview/camera.h"
#include "splitsum/preview/scene.h"
#include "splitsum/truth/surface.h"

namespace splitsum {

/// What is seen of a scene, as surfaces in panorama space with the exact split sum of their view.
/// Cost: that of a ViewSplitSum for each roughness in the scene. `scene` must outlive it.
class SphereSurfaces {
public:
    SphereSurfaces(const Scene& scene, const Mat3d& panorama_from_cube);

    Surface at(const SeenSurface& seen) const;

private:
    const Scene& scene_;
    Mat3d panorama_from_cube_;
    std::vector<std::shared_ptr<const ViewSplitSum>> split_sums_;  // of each sphere
};

}  // namespace splitsum
