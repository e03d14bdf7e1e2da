#include "splitsum/filter/filter_tables.h"

#include <algorithm>

#include "splitsum/base/parallel.h"
#include "splitsum/brdf/band_factors.h"

namespace splitsum {

// Making may use parallel loops. A thread that waits for the last rows of one must not start a task
// that asks for the same table: it would wait for itself.
template <class Table, class Make>
std::shared_ptr<const Table> FilterTables::made_once(Entry<Table>& entry, bool keep,
                                                     const Make& make) {
    const std::lock_guard lock(entry.making);
    if (auto table = entry.used.lock()) return table;
    const std::shared_ptr<const Table> table = run_alone(make);
    entry.used = table;
    if (keep) entry.kept = table;
    return table;
}

FilterTables::Factors FilterTables::band_factors(const Lobe& lobe, int count) {
    FactorsEntry* entry = nullptr;
    {
        const std::lock_guard lock(mutex_);
        entry = &factors_[std::pair(std::pair(lobe.kind, lobe.alpha), count)];
    }
    return made_once(*entry, true, [&] {
        return std::make_shared<const std::vector<double>>(splitsum::band_factors(lobe, count));
    });
}

FilterTables::GeometryEntry FilterTables::entry_of(const GeometryOf& geometry) {
    constexpr size_t most = 4;
    const std::lock_guard lock(mutex_);
    const auto found =
        std::ranges::find(geometries_, geometry, &std::pair<GeometryOf, GeometryEntry>::first);
    if (found != geometries_.end()) return found->second;
    if (geometries_.size() == most) geometries_.pop_front();
    geometries_.emplace_back(geometry, std::make_shared<Entry<AreaGeometry>>());
    return geometries_.back().second;
}

FilterTables::Geometry FilterTables::area_geometry(int height, int face_size,
                                                   const Mat3d& panorama_from_cube) {
    // About 12 bytes for each row and texel along an edge; the cheapest to keep are the most wanted.
    constexpr int64_t most_kept = 4 << 20;
    const bool keep = 12 * int64_t{height} * face_size <= most_kept;
    const GeometryEntry entry = entry_of({height, face_size, panorama_from_cube});
    return made_once(*entry, keep, [&] {
        return std::make_shared<const AreaGeometry>(height, face_size, panorama_from_cube);
    });
}

}  // namespace splitsum
