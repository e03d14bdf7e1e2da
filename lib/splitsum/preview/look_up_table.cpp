#include "splitsum/preview/look_up_table.h"

#include "splitsum/base/text.h"
#include "splitsum/table/grid.h"
#include "splitsum/table/split_sum_lookup.h"

namespace splitsum {
namespace {

constexpr const char* remedy =
    "splitsum-brdf -o FILE makes one that can be read, with --table ggx or ggx-multiscatter, "
    "--layout centre and --roughness-axis perceptual, its defaults";

Error refused(const std::string& what) {
    return {ErrorKind::unusable_input, cat(what, "; ", remedy)};
}

}  // namespace

Result<Table> look_up_table(const Table& stored, const TablePlan& plan) {
    const bool multiscatter = plan.kind == "ggx-multiscatter";
    if (plan.kind != "ggx" && !multiscatter)
        return refused(cat("is a table '", plan.kind, "', which holds no split sum"));
    if (plan.layout != TexelLayout::centre) return refused("has its texels at the edges");
    if (plan.roughness_axis != RoughnessAxis::perceptual)
        return refused("has an axis of alpha, not of perceptual roughness");
    if (stored.channels < 2 || stored.layers != 1)
        return refused(cat("has ", stored.channels, " channels in ", stored.layers, " layers"));

    const Table upright = canonical_of(stored, plan);
    Table table = blank_table(upright.width, upright.height, 2);
    for (int y = 0; y < table.height; ++y)
        for (int x = 0; x < table.width; ++x) {
            const auto from = upright.texel(x, y);
            const SplitSum sum = multiscatter ? split_sum_of_multiscatter(from[0], from[1])
                                              : SplitSum{from[0], from[1]};
            table.texel(x, y)[0] = float(sum.a);
            table.texel(x, y)[1] = float(sum.b);
        }
    return table;
}

}  // namespace splitsum
