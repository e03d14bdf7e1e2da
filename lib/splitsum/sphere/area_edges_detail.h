#pragma once

#include <vector>

#include "splitsum/math/vec.h"
#include "splitsum/sphere/area_geometry.h"
#include "splitsum/sphere/area_kernels.h"
#include "splitsum/sphere/cubemap.h"

namespace splitsum {

/// Adds weight * value to `sum`, each place receiving what lies `turned` quarter turns further on.
template <size_t turned>
void add_turned(FourTurns& sum, double weight, const FourTurns& value) {
    for (size_t turn = 0; turn < 4; ++turn) sum[turn] += weight * value[(turn + turned) % 4];
}

/// ∫ F dphi along the edges of the lattice, F from the top down, in columns times height: of the
/// upper half of the cube, then of the lower half in the same memory.
struct AreaEdges {
    explicit AreaEdges(int face_size)
        : texels(size_t(face_size)), lines(texels * texels), equator(texels) {}

    FourTurns* line(int index) { return lines.data() + size_t(index) * texels; }
    const FourTurns* line(int index) const { return lines.data() + size_t(index) * texels; }

    void start_lower_half();

    size_t texels;
    bool lower = false;
    std::vector<FourTurns> lines;    ///< [AreaGeometry's line, or its mirror image][texel]
    std::vector<FourTurns> equator;  ///< the upper half's line next to the equator, when it is done
};

/// Sets each texel above the equator to its mean, from the integrals along its edges.
void fill_upper_half(const AreaGeometry& geometry, const AreaEdges& edges, Cubemap& cubemap);

/// Sets the other texels, from those and from F of whole columns.
void fill_lower_half(const AreaGeometry& geometry, const AreaEdges& edges,
                     const std::vector<FourTurns>& whole_columns, Cubemap& cubemap);

}  // namespace splitsum
