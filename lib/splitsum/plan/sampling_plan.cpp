#include "splitsum/plan/sampling_plan.h"

#include <array>

namespace splitsum {
namespace {

constexpr std::array<NamedValue<PointSequence>, 2> sequences = {{
    {PointSequence::hammersley, "hammersley", "evenly spread points: errors fall nearly as 1 / N"},
    {PointSequence::random, "random",
     "independent points at every texel: errors fall as 1 / sqrt N"},
}};

constexpr std::array<NamedValue<MisHeuristic>, 2> heuristics = {{
    {MisHeuristic::power, "power", "by the squares of the densities (Veach & Guibas 1995, beta 2)"},
    {MisHeuristic::balance, "balance", "by the densities themselves"},
}};

}  // namespace

std::span<const NamedValue<PointSequence>> point_sequences() { return sequences; }
std::span<const NamedValue<MisHeuristic>> mis_heuristics() { return heuristics; }

}  // namespace splitsum
