#pragma once

#include "splitsum/ltc/shape.h"
#include "splitsum/ltc/target_lobe.h"

namespace splitsum {

/// How finely a fit looks. The defaults are what the stated figures were measured with.
struct LtcFitPlan {
    int nodes = 20;          ///< along each side of the two squares that directions come from
    int order = 6;           ///< highest band of the harmonics that compare the lobes
    int rounds = 2;          ///< how often directions are placed anew around the lobe so far
    int steps = 12;          ///< at most, of Levenberg-Marquardt in each round
    double accuracy = 1e-5;  ///< a round ends with a step below this, in units of the parameters
};

/// The shape that stands for `target` best, from `start` on: a lobe near by, such as that of the
/// neighbour in a table. Polygonal lights see integrals of a lobe over their area, so what is
/// minimised is the difference e of the two densities as integrals see it,
///
///     sum over bands l of (<e, Y_lm>² over the world + 1/4 <e, Y_lm>² over cosine space) / (l + 1/2)²
///       + 0.0003 ∫ e² / (mean of the densities) + 0.0001 tilt²
///
/// (Heitz et al. 2016 minimise ∫ |e|³, which follows the peak: shaded polygons then miss by three to
/// four times as much.) The second space sees narrow lobes as it sees wide ones; chi² keeps in place
/// what no harmonic sees, and the last term the cut-off of narrow lobes, which nothing sees.
/// Integrals by two sets of directions, one that follows the target and one that follows the lobe,
/// joined by the balance heuristic (Veach & Guibas 1995).
///
/// Deterministic; always finite. Cost: about 1 ms.
LtcShape fit_ltc(const TargetLobe& target, const LtcShape& start, const LtcFitPlan& plan = {});

}  // namespace splitsum
