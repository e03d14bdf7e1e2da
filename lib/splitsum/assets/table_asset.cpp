#include "splitsum/assets/table_asset.h"

#include <algorithm>

#include "splitsum/base/text.h"
#include "splitsum/report/asset_facts.h"

namespace splitsum {
namespace {

Status check_format(const TableKind& kind, const PixelFormatInfo& format) {
    if (holds_tables(format) && format.channels >= kind.channels()) return ok;
    std::vector<std::string_view> usable;
    for (const PixelFormatInfo& other : pixel_formats())
        if (holds_tables(other) && other.channels >= kind.channels()) usable.push_back(other.name);
    return Error{ErrorKind::bad_argument, cat("the table '", kind.name, "' has ", kind.channels(),
                                              " channels, which the format ", format.name,
                                              " cannot hold; usable are ", join(usable, ", "))};
}

// What an engine reads, without the channels that the format adds.
Table read_back(const TextureAsset& texture, const Table& original) {
    Table table = blank_table(texture.width, texture.height, original.channels, original.layers);
    decode_texels(texture.format, original.channels, texture.levels.front(), table.values);
    return table;
}

Result<TableAsset> encoded(const TableKind& kind, const TablePlan& plan, PixelFormat format,
                           const Table& table) {
    EncodeCounts counts;
    TableAsset asset{kind, plan, {}, texture_from_table(table, format, counts), {}};
    if (counts.saturated + counts.negative > 0)
        return Error{ErrorKind::bad_argument,
                     cat(counts.saturated + counts.negative, " values of the table '", kind.name,
                         "' lie outside of what the format ", info_of(format).name,
                         " can hold; rg16f, rg32f, rgba16f and rgba32f hold more")};
    asset.table = read_back(asset.texture, table);
    return asset;
}

AssetFacts facts_of_table(const TableAsset& asset) {
    AssetFacts facts;
    facts.kind = AssetFacts::Kind::table;
    facts.table.plan = asset.plan;
    facts.table.value = asset.kind.value;
    facts.table.view_axis = asset.kind.view_axis == ViewAxis::cosine ? "n.v" : "sqrt(1 - n.v)";
    facts.table.has_geometry = asset.kind.has_geometry;
    facts.table.max_abs = asset.check.at_texels;
    facts.table.max_abs_between = asset.check.between;
    return facts;
}

TableProbes probes_of(const TableKind& kind) {
    return {.texels = kind.probes / 2, .points = kind.probes};
}

// A table of a size that is a number.
Result<TableAsset> bake_sized(const TableKind& kind, const TablePlan& plan, PixelFormat format,
                              const TableProbes& probes, Progress& progress) {
    const auto canonical = kind.bake(plan, grid_of(plan, kind.view_axis), progress);
    if (!canonical) return canonical.error();
    auto asset = encoded(kind, plan, format, arranged(*canonical, plan));
    if (!asset) return asset.error();
    asset->check = check_table(kind, plan, asset->table, probes);
    asset->texture.metadata = metadata_of(facts_of_table(*asset));
    return asset;
}

}  // namespace

Result<TableAsset> bake_table(const TablePlan& plan, PixelFormat format, Progress& progress) {
    if (const Status valid = validate(plan); !valid) return valid.error();
    const auto kind = kind_of(plan);
    if (!kind) return kind.error();
    if (const Status fits = check_format(*kind, info_of(format)); !fits) return fits.error();
    return bake_sized(*kind, plan, format, probes_of(*kind), progress);
}

}  // namespace splitsum
