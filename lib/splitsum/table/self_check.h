#pragma once

#include "splitsum/base/progress.h"
#include "splitsum/image/table.h"
#include "splitsum/table/kinds.h"

namespace splitsum {

/// What a self-check found: the largest |read - exact| (max_abs) of what a renderer reads.
struct TableCheck {
    double at_texels = 0;  ///< exactly at texels, edges and corners among them
    double between = 0;    ///< at points spread over all that lies between texels, read bilinearly
    /// Along the border of [0, 1]², half a texel outside of the outermost centres, where clamp-to-edge
    /// holds their value; 0 with texels at the edges, where there is no such rim.
    double in_rim = 0;
    int texels = 0;  ///< how many were judged
    int points = 0;
    int rim_points = 0;
};

/// How many of each.
struct TableProbes {
    int along_edge = 5;  ///< texels along each edge
    int texels = 64;     ///< Hammersley points inside, rounded to texels
    int points = 128;    ///< between texels, by an additive sequence that meets no grid
    int rim_points = 32;
};

/// Judges `stored`, the arranged table of a plan whose size is a number, by TableKind::error_of.
/// Deterministic. Cost: about 1 ms a probe for tables of the split sum.
TableCheck check_table(const TableKind& kind, const TablePlan& plan, const Table& stored,
                       const TableProbes& probes);

}  // namespace splitsum
