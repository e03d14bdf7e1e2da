#include "splitsum/plan/table_plan.h"

#include <algorithm>
#include <array>

#include "splitsum/base/text.h"

namespace splitsum {
namespace {

constexpr int largest_table = 8192;
constexpr int most_samples = 1 << 24;
constexpr double finest_accuracy = 1e-7;
constexpr double coarsest_accuracy = 0.1;
// A coarser one would save a few milliseconds of a 512² table.
constexpr double coarsest_quadrature = 1e-4;

constexpr std::array<NamedValue<TexelLayout>, 2> layouts = {{
    {TexelLayout::centre, "centre",
     "texel i at (i + 1/2) / size, where a sampler looks for coordinates 0 to 1"},
    {TexelLayout::edge, "edge", "texel i at i / (size - 1): first and last exactly at 0 and 1"},
}};

constexpr std::array<NamedValue<TableAxes>, 2> axes = {{
    {TableAxes::nv_roughness, "nv-roughness", "x = n.v, y = roughness (Khronos, Bevy, Filament)"},
    {TableAxes::roughness_nv, "roughness-nv", "x = roughness, y = n.v (three.js)"},
}};

constexpr std::array<NamedValue<RoughnessAxis>, 2> roughness_units = {{
    {RoughnessAxis::perceptual, "perceptual", "perceptual roughness r, the artist's slider"},
    {RoughnessAxis::alpha, "alpha", "the width alpha = r^2 of the lobe"},
}};

Status check_size(const TablePlan& plan) {
    if (plan.size == TablePlan::automatic_size && !plan.accuracy)
        return Error{ErrorKind::bad_argument,
                     "an automatic size needs an accuracy to meet, such as 1e-3; none was given"};
    if (plan.size == TablePlan::automatic_size) return ok;
    if (plan.size < 1 || plan.size > largest_table)
        return Error{ErrorKind::bad_argument, cat("the size of the table must be from 1 to ",
                                                  largest_table, ", got ", plan.size)};
    if (plan.layout == TexelLayout::edge && plan.size < 2)
        return Error{ErrorKind::bad_argument,
                     "a table with texels at 0 and at 1 has at least 2 of them along an edge, got "
                     "1; the layout 'centre' takes 1"};
    return ok;
}

Status check_accuracy(const TablePlan& plan) {
    if (!plan.accuracy) return ok;
    if (*plan.accuracy >= finest_accuracy && *plan.accuracy <= coarsest_accuracy) return ok;
    return Error{ErrorKind::bad_argument,
                 cat("the accuracy of a table must be from ", finest_accuracy, " to ",
                     coarsest_accuracy, ", got ", *plan.accuracy)};
}

}  // namespace

std::span<const NamedValue<TexelLayout>> texel_layouts() { return layouts; }
std::span<const NamedValue<TableAxes>> table_axes() { return axes; }
std::span<const NamedValue<RoughnessAxis>> roughness_axes() { return roughness_units; }

double quadrature_tolerance(const TablePlan& plan) {
    const double share = plan.size == TablePlan::automatic_size ? 0.1 : 0.5;
    return plan.accuracy ? std::clamp(share * *plan.accuracy, 1e-7, coarsest_quadrature)
                         : default_table_accuracy;
}

Status validate(const TablePlan& plan) {
    if (const Status size = check_size(plan); !size) return size;
    if (plan.samples < 1 || plan.samples > most_samples)
        return Error{ErrorKind::bad_argument, cat("the number of samples must be from 1 to ",
                                                  most_samples, ", got ", plan.samples)};
    return check_accuracy(plan);
}

}  // namespace splitsum
