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
    constexpr float rounding = 1e-5F;  // 1 + that is 1, not a value that does not fit
    EncodeCounts counts;
    TableAsset asset{kind, plan, {}, texture_from_table(table, format, counts), {}};
    asset.table = read_back(asset.texture, table);
    if (counts.saturated + counts.negative == 0) return asset;
    const PixelFormatInfo& info = info_of(format);
    const auto [least, largest] = std::ranges::minmax(table.values);
    if (largest <= info.largest[0] + rounding && (info.holds_negative || least >= -rounding))
        return asset;
    return Error{ErrorKind::bad_argument,
                 cat("the table '", kind.name, "' has values from ", least, " to ", largest,
                     ", which the format ", info.name,
                     " cannot hold; rg16f, rg32f, rgba16f and rgba32f hold more")};
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
    facts.table.max_abs_in_rim = asset.check.in_rim;
    return facts;
}

TableProbes probes_of(const TableKind& kind) {
    return {.along_edge = std::clamp(kind.probes / 16, 2, 5),
            .texels = kind.probes / 2,
            .points = kind.probes,
            .rim_points = kind.probes / 4};
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

double worst_of(const TableCheck& check) { return std::max(check.at_texels, check.between); }

// What else the user could ask for.
std::string advice(const TablePlan& plan, PixelFormat format) {
    std::string text = "a larger --accuracy";
    if (plan.layout == TexelLayout::centre) text += ", --layout edge";
    const PixelFormatInfo& info = info_of(format);
    if (info.bytes_per_texel < 4 * info.channels)
        text += cat(", --format ", info.channels == 2 ? "rg32f" : "rgba32f");
    if (plan.method != TablePlan{}.method) text += cat(", --method ", TablePlan{}.method);
    return text;
}

// Four times as many points decide about a size, once the usual ones are met.
Result<TableAsset> bake_automatic(const TableKind& kind, const TablePlan& plan, PixelFormat format,
                                  Progress& progress) {
    TablePlan sized = plan;
    std::string reached;
    for (int size = smallest_automatic_size; size <= largest_automatic_size; size *= 2) {
        sized.size = size;
        auto asset = bake_sized(kind, sized, format, probes_of(kind), progress);
        if (!asset) return asset;
        TableProbes probes = probes_of(kind);
        probes.points *= 4;
        if (worst_of(asset->check) <= *plan.accuracy)
            asset = bake_sized(kind, sized, format, probes, progress);
        if (!asset || worst_of(asset->check) <= *plan.accuracy) return asset;
        reached = cat("size ", size, " reaches ", worst_of(asset->check));
    }
    return Error{
        ErrorKind::bad_argument,
        cat("no size from ", smallest_automatic_size, " to ", largest_automatic_size,
            " brings the table '", kind.name, "' within ", *plan.accuracy,
            " at texels and between them: ", reached, "; what helps is ", advice(plan, format))};
}

// The accuracy that was asked for, at texels.
Status check_accuracy(const TableAsset& asset) {
    if (!asset.plan.accuracy || asset.check.at_texels <= *asset.plan.accuracy) return ok;
    return Error{ErrorKind::bad_argument,
                 cat("the table '", asset.kind.name, "' misses the accuracy ", *asset.plan.accuracy,
                     ": max_abs is ", asset.check.at_texels, " with ", asset.plan.method, " in ",
                     info_of(asset.texture.format).name, "; what helps is ",
                     advice(asset.plan, asset.texture.format))};
}

}  // namespace

PixelFormat default_format(const TableKind& kind) {
    if (kind.channels() > 2) return kind.wants_floats ? PixelFormat::rgba32f : PixelFormat::rgba16f;
    return kind.wants_floats ? PixelFormat::rg32f : PixelFormat::rg16f;
}

Result<TableAsset> bake_table(const TablePlan& plan, PixelFormat format, Progress& progress) {
    if (const Status valid = validate(plan); !valid) return valid.error();
    const auto kind = kind_of(plan);
    if (!kind) return kind.error();
    if (const Status fits = check_format(*kind, info_of(format)); !fits) return fits.error();
    if (plan.size == TablePlan::automatic_size)
        return bake_automatic(*kind, plan, format, progress);
    auto asset = bake_sized(*kind, plan, format, probes_of(*kind), progress);
    if (!asset) return asset;
    if (const Status met = check_accuracy(*asset); !met) return met.error();
    return asset;
}

}  // namespace splitsum
