#pragma once

#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "splitsum/brdf/lobe.h"
#include "splitsum/math/vec.h"
#include "splitsum/sphere/area_geometry.h"

namespace splitsum {

/// What filters need that depends on lobes and sizes but not on the light, made when it is first
/// asked for and kept, so that the panoramas of a run pay for it once. What is returned does not
/// depend on what was asked for before. Safe to use from many threads.
///
/// Memory: 8 bytes a band factor; the last four geometries.
class FilterTables {
public:
    using Factors = std::shared_ptr<const std::vector<double>>;
    using Geometry = std::shared_ptr<const AreaGeometry>;

    /// The first `count` band factors of the lobe (brdf/band_factors.h).
    Factors band_factors(const Lobe& lobe, int count);

    /// Where the texels of a cube meet those of a panorama of `height` rows.
    Geometry area_geometry(int height, int face_size, const Mat3d& panorama_from_cube);

private:
    struct GeometryOf {
        int height;
        int face_size;
        Mat3d panorama_from_cube;

        bool operator==(const GeometryOf&) const = default;
    };

    std::mutex mutex_;
    std::map<std::pair<std::pair<LobeKind, double>, int>, Factors> factors_;
    std::deque<std::pair<GeometryOf, Geometry>> geometries_;
};

}  // namespace splitsum
