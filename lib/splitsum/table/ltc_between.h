#pragma once

#include <span>
#include <vector>

#include "splitsum/ltc/transformed_cosine.h"
#include "splitsum/table/grid.h"

namespace splitsum {

/// Moves matrices so that they are right between the texels of a view axis where they are read,
/// bilinearly, rather than at texels alone. `matrices` are those of fit_ltc_table over
/// `grid`, whose views are evenly spaced in sqrt(1 - n·v).
///
/// As alpha -> 0 a matrix is diag(n·v, 1, 2 alpha n·v) R, and what a linear filter makes of two of them
/// points beside the mirror direction; lobes that are narrower than that miss the edges of lights.
/// - Entries m become m - m'' / 12, m'' the second difference along the axis: the piecewise linear
///   function next to a parabola in the least-squares sense, 2.4 times as near (rms) as the one through
///   its points.
/// - Below a roughness of 0.02 even that points further beside the mirror direction (1e-3) than the lobe is
///   wide (alpha). There the first row is stretched from length n·v to ((1 + n·v) / 2)^(1/4), with which
///   the direction is right to 1e-5 everywhere. The lobe's width in the plane of reflection goes with it,
///   which matters less: it is 0.05 degrees at most. Entries m00 and m02 jump to the next row.
/// - Towards n·v = 0 the first row of the matrix, n·v (n·v, s), vanishes and its direction with it: the
///   texel at 0 keeps the neighbour's m02 and gets m00 = 0, with which m00 / m02 is n·v / s in all
///   of the last interval.
///   Fades out where lobes are wide.
/// Determinants stay positive.
void fit_between_views(std::span<LtcInverse> matrices, const TableGrid& grid);

/// The last interval of a view axis, between its last but one view and n·v = 0, as quadrature sees it.
struct LastInterval {
    std::vector<double> n_dot_v;  ///< of the nodes
    std::vector<double>
        at_edge;  ///< the share that a linear filter takes of the texel at 0, in [0, 1]
    std::vector<double> weights;  ///< of views that are evenly spread in n·v
};

/// Empty where the grid does not end with a texel at n·v = 0.
LastInterval last_interval(const TableGrid& grid);

/// What the texel at 0 holds for a linear filter to be nearest to `exact`, given at the nodes, in the
/// least-squares sense: a narrow lobe's albedo dips below 1 at n·v near alpha, between the texels.
/// `neighbour` is the texel before. In [0, 1].
double value_edge_on(const LastInterval& interval, double neighbour, std::span<const double> exact);

}  // namespace splitsum
