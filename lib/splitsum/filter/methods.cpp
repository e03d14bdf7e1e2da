#include "splitsum/filter/methods.h"

#include <vector>

#include "splitsum/base/text.h"
#include "splitsum/filter/auto_method.h"
#include "splitsum/filter/mis.h"
#include "splitsum/filter/reference.h"
#include "splitsum/filter/sampled.h"
#include "splitsum/filter/spectral.h"

namespace splitsum {
namespace {

bool filters(const FilterMethod& method, LobeKind kind) {
    return kind == LobeKind::ggx ? method.filters_ggx : method.filters_cosine;
}

}  // namespace

std::span<const FilterMethod> filter_methods() {
    static constexpr FilterMethod methods[] = {
        {"auto", "the cheapest that meets --accuracy for each level; the report says which", true,
         true, prepare_auto},
        {"reference", "fp64 sum over every texel, exact and slow: the judge of the others", true,
         true, prepare_reference},
        {"riemann", "uniform grid over the hemisphere, the textbook diffuse loop", false, true,
         prepare_riemann},
        {"importance", "points through the lobe's distribution; ghosts of small suns", true, true,
         prepare_importance, true},
        {"filtered", "the same points, each read from a prefiltered pyramid; lobes grow a little",
         true, true, prepare_filtered, true},
        {"mis", "points through lobe and light, weighted by --heuristic; unbiased, noisy", true,
         true, prepare_mis, true, true},
        {"spectral", "product with the lobe's band factors in spherical-harmonic space; exact",
         true, true, prepare_spectral},
    };
    return methods;
}

Result<FilterMethod> find_filter_method(std::string_view name, LobeKind kind) {
    std::vector<std::string_view> usable;
    for (const FilterMethod& method : filter_methods()) {
        if (!filters(method, kind)) continue;
        if (method.name == name) return method;
        usable.push_back(method.name);
    }
    return Error{
        ErrorKind::bad_argument,
        cat("no method '", name, "' for ", kind == LobeKind::ggx ? "reflections" : "diffuse light",
            "; there are: ", join(usable, ", "))};
}

}  // namespace splitsum
