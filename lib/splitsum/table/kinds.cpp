#include "splitsum/table/kinds.h"

#include <array>

#include "splitsum/base/text.h"
#include "splitsum/table/albedo_tables.h"
#include "splitsum/table/ggx_tables.h"
#include "splitsum/table/ltc_tables.h"
#include "splitsum/table/split_sum.h"
#include "splitsum/table/split_sum_fit.h"

namespace splitsum {
namespace {

constexpr std::string_view ggx_channels[] = {"scale", "bias"};
constexpr std::string_view multiscatter_channels[] = {"bias", "albedo"};

constexpr std::string_view energy_channels[] = {"albedo", "average_albedo"};
constexpr std::string_view lost_channels[] = {"lost", "average_lost"};
constexpr std::string_view albedo_channels[] = {"albedo"};
constexpr std::string_view ltc_channels[] = {"m00",    "m20",      "m02",  "m22",
                                             "albedo", "weighted", "zero", "sphere"};

// As three.js and Bevy read the tables of area lights.
constexpr TableDefaults ltc_defaults = {
    .size = 64, .layout = TexelLayout::edge, .axes = TableAxes::roughness_nv};

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
     .probes = 64,
     .wants_floats = true,
     .bake = bake_energy,
     .error_of = error_of_energy},
    {.name = "energy-lost",
     .summary = "(1 - E, 1 - E_avg), the latter of what is read: a white furnace at every size",
     .value = "red = 1 - E(n.v, r) of a perfect reflector; green = 2 integral red mu dmu as read "
              "bilinearly",
     .channel_names = lost_channels,
     .probes = 64,
     .wants_floats = true,
     .bake = bake_energy_lost,
     .error_of = error_of_energy_lost},
    {.name = "charlie",
     .summary = "cloth's albedo, visibility of Neubelt & Pettineo (Filament, glTF sheen)",
     .value = "albedo of cloth: Charlie (alpha = r^2), V = 1 / (4 (n.l + n.v - n.l n.v))",
     .channel_names = albedo_channels,
     .has_geometry = false,
     .has_methods = false,
     .bake = bake_charlie,
     .error_of = error_of_charlie},
    {.name = "charlie-clamped",
     .summary = "the same with V at most 1 (Khronos' sampler, three.js)",
     .value = "albedo of cloth: Charlie (alpha = r^2), V = min(1, 1 / (4 (n.l + n.v - n.l n.v)))",
     .channel_names = albedo_channels,
     .has_geometry = false,
     .has_methods = false,
     .bake = bake_charlie_clamped,
     .error_of = error_of_charlie_clamped},
    {.name = "charlie-smith",
     .summary = "the same with the Smith term that Estevez & Kulla 2017 fitted",
     .value = "albedo of cloth: Charlie (alpha = r^2), V = 1 / (4 n.l n.v (1 + L(l) + L(v)))",
     .channel_names = albedo_channels,
     .has_geometry = false,
     .has_methods = false,
     .bake = bake_charlie_smith,
     .error_of = error_of_charlie_smith},
    {.name = "diffuse-disney",
     .summary = "albedo of Burley's diffuse lobe of 2012",
     .value = "albedo of Disney diffuse (Burley 2012)",
     .channel_names = albedo_channels,
     .has_geometry = false,
     .has_methods = false,
     .bake = bake_diffuse_disney,
     .error_of = error_of_diffuse_disney},
    {.name = "diffuse-renormalised",
     .summary = "albedo of the same as Lagarde & de Rousiers 2014 renormalised it",
     .value = "albedo of Disney diffuse, renormalised (Lagarde & de Rousiers 2014)",
     .channel_names = albedo_channels,
     .has_geometry = false,
     .has_methods = false,
     .bake = bake_diffuse_renormalised,
     .error_of = error_of_diffuse_renormalised},
    {.name = "ltc-ggx",
     .summary = "polygonal lights: transformed cosines of GGX (Heitz et al. 2016), 2 layers",
     .value = "layer 0: inverse matrix m00 m20 m02 m22, middle entry 1; layer 1: albedo for F = 1, "
              "to 1 %, the same weighted with (1 - v.h)^5, 0, horizon-clipped sphere; "
              "height-correlated Smith",
     .channel_names = ltc_channels,
     .layers = 2,
     .view_axis = ViewAxis::sqrt_one_minus_cosine,
     .has_geometry = false,
     .has_methods = false,
     .defaults = ltc_defaults,
     .bake = bake_ltc_ggx,
     .error_of = error_of_ltc_ggx},
    {.name = "ltc-disney",
     .summary = "the same for Burley's diffuse lobe",
     .value =
         "layer 0: inverse matrix m00 m20 m02 m22, middle entry 1; layer 1: albedo to 1 %, 0, 0, "
         "horizon-clipped sphere; Disney diffuse (Burley 2012)",
     .channel_names = ltc_channels,
     .layers = 2,
     .view_axis = ViewAxis::sqrt_one_minus_cosine,
     .has_geometry = false,
     .has_methods = false,
     .defaults = ltc_defaults,
     .bake = bake_ltc_disney,
     .error_of = error_of_ltc_disney},
    {.name = "ggx-fit",
     .summary = "(a, b) as a formula of 35 terms for targets without a texture: .glsl, .hpp, .json",
     .value = "split sum: albedo = F0 * x + y",
     .channel_names = ggx_channels,
     .has_methods = false,
     .probes = 512,
     .bake = bake_ggx_fit,
     .error_of = error_of_ggx,
     .evaluate = evaluate_ggx_fit},
};

}  // namespace

std::span<const TableKind> table_kinds() { return kinds; }

TablePlan default_plan(const TableKind& kind) {
    TablePlan plan;
    plan.kind = kind.name;
    plan.size = kind.defaults.size;
    plan.layout = kind.defaults.layout;
    plan.axes = kind.defaults.axes;
    return plan;
}

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
