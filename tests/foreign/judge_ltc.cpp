// Polygonal lights shaded by the table that Splitsum bakes and by the one that was published with
// Heitz et al. 2016, both against integration: judge_ltc FOLDER, where dump_published_ltc.mjs wrote
// the latter. Fails unless ours is at least as near.

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <span>

#include "splitsum/base/text.h"
#include "splitsum/table/kinds.h"
#include "support/polygon_lights.h"

namespace splitsum {
namespace {

TablePlan plan_as_published() {
    TablePlan plan;
    plan.kind = "ltc-ggx";
    plan.size = 64;
    plan.layout = TexelLayout::edge;
    plan.axes = TableAxes::roughness_nv;
    return plan;
}

Result<Table> baked(const TablePlan& plan) {
    NoProgress progress;
    const auto kind = kind_of(plan);
    if (!kind) return kind.error();
    const auto table = kind->bake(plan, grid_of(plan, kind->view_axis), progress);
    if (!table) return table.error();
    return arranged(*table, plan);
}

// Layer by layer, as the two textures lie.
Result<Table> published(const std::filesystem::path& folder) {
    Table table = blank_table(64, 64, 4, 2);
    const std::span<float> values(table.values);
    const size_t half = values.size() / 2;
    for (const size_t layer : {0, 1}) {
        const std::filesystem::path path = folder / cat("ltc_", layer + 1, ".f32");
        std::ifstream file(path, std::ios::binary);
        const auto into = std::as_writable_bytes(values.subspan(layer * half, half));
        if (!file.read(reinterpret_cast<char*>(into.data()),
                       static_cast<std::streamsize>(into.size())))
            return Error{ErrorKind::unreadable_input, cat("cannot read ", path)};
    }
    return table;
}

Status judge(const std::filesystem::path& folder) {
    const TablePlan plan = plan_as_published();
    const auto theirs = published(folder);
    if (!theirs) return theirs.error();
    const auto ours = baked(plan);
    if (!ours) return ours.error();
    const ShadingErrors their = shading_errors(*theirs, plan, LtcTarget::ggx);
    const ShadingErrors our = shading_errors(*ours, plan, LtcTarget::ggx);
    std::printf("rms of the radiance: published %.5f, ours %.5f; of the value: %.4f, %.4f\n",
                their.rms, our.rms, their.rel_rms, our.rel_rms);
    // Measured 0.018 and 0.0043; a published table read with its axes swapped would be far above.
    if (their.rms > 0.03)
        return Error{ErrorKind::unusable_input, "the published table was not read as it is meant"};
    if (our.rms > 0.5 * their.rms)
        return Error{ErrorKind::internal, "the table is not twice as near as the published one"};
    return ok;
}

}  // namespace
}  // namespace splitsum

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: judge_ltc FOLDER\n");
        return 2;
    }
    const splitsum::Status status = splitsum::judge(argv[1]);
    if (status) return 0;
    std::fprintf(stderr, "judge_ltc: %s\n", status.error().message.c_str());
    return 1;
}
