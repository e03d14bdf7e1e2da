#pragma once

#include <cstdint>
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
/// depend on what was asked for before.
///
/// Safe to use from many threads: who asks for a table that another thread is making waits for it,
/// and nobody else does.
///
/// Memory: 8 bytes a band factor; the last four geometries of up to 4 MB. Larger ones are kept by
/// those who use them.
class FilterTables {
public:
    using Factors = std::shared_ptr<const std::vector<double>>;
    using Geometry = std::shared_ptr<const AreaGeometry>;

    /// The first `count` band factors of the lobe (brdf/band_factors.h).
    Factors band_factors(const Lobe& lobe, int count);

    /// Where the texels of a cube meet those of a panorama of `height` rows.
    Geometry area_geometry(int height, int face_size, const Mat3d& panorama_from_cube);

private:
    // A table that is made once, by whoever asks first.
    template <class Table>
    struct Entry {
        std::mutex making;
        std::shared_ptr<const Table> kept;
        std::weak_ptr<const Table> used;
    };
    template <class Table, class Make>
    static std::shared_ptr<const Table> made_once(Entry<Table>& entry, bool keep, const Make& make);

    struct GeometryOf {
        int height;
        int face_size;
        Mat3d panorama_from_cube;

        bool operator==(const GeometryOf&) const = default;
    };
    using FactorsEntry = Entry<std::vector<double>>;
    using GeometryEntry = std::shared_ptr<Entry<AreaGeometry>>;
    GeometryEntry entry_of(const GeometryOf& geometry);

    std::mutex mutex_;  // of the lists, not of what they hold
    std::map<std::pair<std::pair<LobeKind, double>, int>, FactorsEntry> factors_;
    std::deque<std::pair<GeometryOf, GeometryEntry>> geometries_;
};

}  // namespace splitsum
