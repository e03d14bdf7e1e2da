#include "splitsum/filter/filter_tables.h"

#include <algorithm>

#include "splitsum/brdf/band_factors.h"

namespace splitsum {

// Tables are made outside the lock: two threads may make the same one, and the first is kept.

FilterTables::Factors FilterTables::band_factors(const Lobe& lobe, int count) {
    const std::pair key(std::pair(lobe.kind, lobe.alpha), count);
    {
        const std::lock_guard lock(mutex_);
        if (const auto found = factors_.find(key); found != factors_.end()) return found->second;
    }
    auto made = std::make_shared<const std::vector<double>>(splitsum::band_factors(lobe, count));
    const std::lock_guard lock(mutex_);
    return factors_.emplace(key, std::move(made)).first->second;
}

FilterTables::Geometry FilterTables::area_geometry(int height, int face_size,
                                                   const Mat3d& panorama_from_cube) {
    const GeometryOf key{height, face_size, panorama_from_cube};
    const auto find = [&] {
        return std::ranges::find(geometries_, key, &std::pair<GeometryOf, Geometry>::first);
    };
    {
        const std::lock_guard lock(mutex_);
        if (const auto found = find(); found != geometries_.end()) return found->second;
    }
    auto made = std::make_shared<const AreaGeometry>(height, face_size, panorama_from_cube);
    const std::lock_guard lock(mutex_);
    if (const auto found = find(); found != geometries_.end()) return found->second;
    constexpr size_t most = 4;
    if (geometries_.size() == most) geometries_.pop_front();
    geometries_.emplace_back(key, made);
    return made;
}

}  // namespace splitsum
