#include "splitsum/table/kinds.h"

#include <array>

#include "splitsum/base/text.h"
#include "splitsum/table/ggx_tables.h"
#include "splitsum/table/split_sum.h"

namespace splitsum {
namespace {

constexpr std::string_view ggx_channels[] = {"scale", "bias"};
constexpr std::string_view multiscatter_channels[] = {"bias", "albedo"};

constexpr std::string_view energy_channels[] = {"albedo", "average_albedo"};

constexpr TableKind kinds[] = {
    {.name = "ggx",
     .summary = "(a, b) of the split sum: albedo = F0 a + b (Karis 2013)",
     .value = "split sum: albedo = F0 * red + green",
     .channel_names = ggx_channels,
     .bake = bake_ggx,
     .error_of = error_of_ggx},
    {.name = "ggx-multiscatter",
     .summary = "(b, a + b): albedo = mix(b, a + b, F0); a + b compensates lost energy",
     .value = "split sum: albedo = mix(red, green, F0); energy compensation 1 + F0 (1 / green - 1)",
     .channel_names = multiscatter_channels,
     .bake = bake_ggx_multiscatter,
     .error_of = error_of_ggx_multiscatter},
    {.name = "energy",
     .summary = "(E, E_avg): albedo for F = 1 and its average (Kulla & Conty 2017)",
     .value = "red = E(n.v, r) of a perfect reflector; green = E_avg(r) = 2 integral E mu dmu",
     .channel_names = energy_channels,
     .probes = 24,
     .bake = bake_energy,
     .error_of = error_of_energy},
};

}  // namespace

std::span<const TableKind> table_kinds() { return kinds; }

Result<TableKind> kind_of(const TablePlan& plan) {
    const auto method = find_split_sum_method(plan.method);
    if (!method) return method.error();
    for (const TableKind& kind : kinds) {
        if (kind.name != plan.kind) continue;
        if (kind.has_methods || plan.method == split_sum_methods().front().name) return kind;
        return Error{ErrorKind::bad_argument,
                     cat("the table '", kind.name, "' is not made by the method '", plan.method,
                         "'; leave it out, or name ", split_sum_methods().front().name)};
    }
    return Error{ErrorKind::bad_argument,
                 cat("no table '", plan.kind, "'; there are: ",
                     join(kinds, ", ", [](const TableKind& kind) { return kind.name; }))};
}

}  // namespace splitsum
