#pragma once

#include "splitsum/base/progress.h"
#include "splitsum/image/table.h"
#include "splitsum/table/kinds.h"

namespace splitsum {

/// What a self-check found: the largest |read - exact| (max_abs) of what a renderer reads.
struct TableCheck {
    double at_texels = 0;  ///< exactly at texels, edges and corners among them
    double between = 0;    ///< at points spread over the whole table, as a linear filter reads them
    int texels = 0;        ///< how many were judged
    int points = 0;
};

/// How many of each.
struct TableProbes {
    int along_edge = 5;  ///< texels along each edge
    int texels = 64;     ///< Hammersley points inside, rounded to texels
    int points = 128;    ///< Hammersley points of [0, 1]², clamp-to-edge as an engine reads them
};

/// Judges `stored`, the arranged table of a plan whose size is a number, by TableKind::error_of.
/// Deterministic. Cost: about 1 ms a probe for tables of the split sum.
TableCheck check_table(const TableKind& kind, const TablePlan& plan, const Table& stored,
                       const TableProbes& probes);

}  // namespace splitsum
