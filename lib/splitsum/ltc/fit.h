#pragma once

#include "splitsum/ltc/shape.h"
#include "splitsum/ltc/target_lobe.h"

namespace splitsum {

/// How finely a fit looks. The defaults are what the stated figures were measured with.
struct LtcFitPlan {
    int nodes = 16;          ///< along each side of the two squares that directions come from
    int rounds = 1;          ///< how often directions are placed anew around the lobe so far
    int steps = 12;          ///< at most, of Levenberg-Marquardt in each round
    double accuracy = 1e-5;  ///< a round ends with a step below this, in units of the parameters
};

/// The shape that stands for `target` best, from `start` on: a lobe near by, such as that of the
/// neighbour in a table. A light sees the integral of a lobe over the directions that it covers, so
/// what is minimised is, with e the difference of the two densities,
///
///     integral of e(x) e(y) k(x, y) over x and y
///         + 1e-5 ∫ e² / (mean of the densities) + 3e-6 tilt² + 0.2 log(magnitude)²,
///     k(x, y) = g(x.z) g(y.z) (1 - |x - y| / 2) / (1 + 0.8 |x - y|),   g(z) = 1 + z / 3 - z² / 20
///
/// With k the chance that a light covers both x and y, the integral is the mean square of the error of
/// a shaded value. Here k is a fit, positive definite, to that chance for the lights of the README; that
/// it vanishes for opposite directions, which no light covers both, is what a right magnitude takes.
/// (Heitz et al. 2016 minimise ∫ |e|³, which follows the peak: shaded polygons then miss by three to
/// four times as much.) The other terms keep in place what no light sees, above all the cut-off of
/// narrow lobes, and the magnitude near that of the target.
/// Integrals by two sets of directions, one that follows the target and one that follows the lobe,
/// joined by the balance heuristic (Veach & Guibas 1995).
///
/// Deterministic; always finite. Cost: about 1 ms.
LtcShape fit_ltc(const TargetLobe& target, const LtcShape& start, const LtcFitPlan& plan = {});

}  // namespace splitsum
