#include "splitsum/table/split_sum.h"

#include <array>
#include <cmath>

#include "splitsum/base/text.h"
#include "splitsum/table/split_sum_importance.h"
#include "splitsum/table/split_sum_quadrature.h"
#include "splitsum/table/split_sum_vndf.h"

namespace splitsum {
namespace {

constexpr std::array<SplitSumMethod, 3> methods = {{
    {"quadrature", "Gauss rules that end at the horizon, exact to --accuracy", false,
     split_sums_by_quadrature},
    {"vndf", "samples of the normals that the viewer sees (Heitz 2018)", true,
     split_sums_by_visible_normals},
    {"importance", "samples of all normals, as tables in circulation are baked (Karis 2013)", true,
     split_sums_by_importance},
}};

}  // namespace

SplitSum mirror_split_sum(double n_dot_v) {
    const double fresnel = std::pow(1 - n_dot_v, 5);
    return {1 - fresnel, fresnel};
}

std::span<const SplitSumMethod> split_sum_methods() { return methods; }

Result<SplitSumMethod> find_split_sum_method(std::string_view name) {
    for (const SplitSumMethod& method : methods)
        if (method.name == name) return method;
    return Error{ErrorKind::bad_argument,
                 cat("no method '", name, "' for tables; there are: ",
                     join(methods, ", ", [](const SplitSumMethod& known) { return known.name; }))};
}

Result<std::vector<SplitSum>> split_sums(const TablePlan& plan, const TableGrid& grid,
                                         Progress& progress) {
    const auto method = find_split_sum_method(plan.method);
    if (!method) return method.error();
    progress.begin("split sum", static_cast<int>(grid.perceptual_roughness.size()));
    auto sums = method->bake(plan, grid, progress);
    if (progress.cancelled())
        return Error{ErrorKind::interrupted, "the table was cancelled before its end"};
    return sums;
}

}  // namespace splitsum
