#include "splitsum/report/asset_facts.h"

#include <algorithm>
#include <array>
#include <iomanip>
#include <numbers>
#include <sstream>
#include <string_view>

#include "splitsum/base/text.h"
#include "splitsum/base/version.h"
#include "splitsum/filter/methods.h"
#include "splitsum/report/metadata_detail.h"

namespace splitsum {
namespace {

constexpr std::array<std::string_view, 3> kind_names = {"specular", "irradiance", "table"};

std::string flag_text(bool flag) { return flag ? "true" : "false"; }

// The row of a method that this program knows.
const FilterMethod* method_named(std::string_view name) {
    const auto methods = filter_methods();
    const auto found = std::ranges::find(methods, name, &FilterMethod::name);
    return found == methods.end() ? nullptr : &*found;
}

void describe_points(const FilterPlan& plan, Metadata& metadata) {
    const FilterMethod* const method = method_named(plan.method);
    if (method && method->draws_points)
        metadata["splitsum.sequence"] = name_of(point_sequences(), plan.sequence);
    if (method && method->weighs_points)
        metadata["splitsum.heuristic"] = name_of(mis_heuristics(), plan.heuristic);
}

void describe_cubemap(const AssetFacts& facts, Metadata& metadata) {
    const Orientation& orientation = facts.orientation;
    metadata["splitsum.convention"] = orientation.convention;
    metadata["splitsum.rotate_degrees"] = number_text(orientation.rotate_degrees);
    metadata["splitsum.mirror"] = flag_text(orientation.mirror);
    metadata["splitsum.color_space"] = "scene-linear Rec.709";
    metadata["splitsum.exposure_stops"] = number_text(facts.source.exposure_stops);
    metadata["splitsum.source"] = facts.source.name;
    metadata["splitsum.source_hash"] = facts.source.hash;
    metadata["splitsum.source_color_space"] = facts.source.color_space;
    metadata["splitsum.repaired_texels"] = number_text(facts.source.repaired_texels);
    metadata["splitsum.method"] = facts.filter.method;
    metadata["splitsum.accuracy"] = number_text(facts.filter.accuracy);
    metadata["splitsum.samples"] = number_text(facts.filter.samples);
    metadata["splitsum.rotate_samples"] = flag_text(facts.filter.rotate_samples);
    metadata["splitsum.seed"] = number_text(facts.filter.seed);
    describe_points(facts.filter, metadata);
}

std::string curve_name(const RoughnessCurve& curve) {
    return curve.kind == RoughnessCurve::Kind::list ? "list" : to_string(curve);
}

void describe_specular(const AssetFacts& facts, Metadata& metadata) {
    metadata["splitsum.value"] = "radiance prefiltered with GGX, n = v = R";
    metadata["splitsum.roughness_curve"] = curve_name(facts.curve);
    metadata["splitsum.perceptual_roughness"] =
        join(facts.perceptual_roughness, " ", [](double r) { return number_text(r); });
}

// "x = n.v, y = perceptual roughness, texel centres, row 0 lowest": for people.
std::string axes_text(const TableFacts& facts) {
    const TablePlan& plan = facts.plan;
    const bool is_alpha = plan.roughness_axis == RoughnessAxis::alpha;
    const std::string roughness = is_alpha ? "alpha" : "perceptual roughness";
    const bool view_first = plan.axes == TableAxes::nv_roughness;
    const bool at_edges = plan.layout == TexelLayout::edge;
    return cat("x = ", view_first ? facts.view_axis : roughness,
               ", y = ", view_first ? roughness : facts.view_axis,
               at_edges ? ", first and last texel at 0 and 1" : ", texel centres",
               plan.flip ? ", row 0 highest" : ", row 0 lowest");
}

// Three digits: figures that were measured.
std::string figure_text(double figure) {
    std::ostringstream text;
    text << std::setprecision(3) << figure;
    return text.str();
}

void describe_table(const TableFacts& facts, Metadata& metadata) {
    const TablePlan& plan = facts.plan;
    metadata["splitsum.table"] = plan.kind;
    metadata["splitsum.value"] = facts.value;
    metadata["splitsum.axes"] = axes_text(facts);
    metadata["splitsum.view_axis"] = facts.view_axis;
    metadata["splitsum.axes_order"] = name_of(table_axes(), plan.axes);
    metadata["splitsum.layout"] = name_of(texel_layouts(), plan.layout);
    metadata["splitsum.roughness_axis"] = name_of(roughness_axes(), plan.roughness_axis);
    metadata["splitsum.flip"] = flag_text(plan.flip);
    if (facts.has_geometry) metadata["splitsum.geometry"] = info_of(plan.geometry).name;
    metadata["splitsum.method"] = plan.method;
    metadata["splitsum.samples"] = number_text(plan.samples);
    metadata["splitsum.max_abs"] = figure_text(facts.max_abs);
    metadata["splitsum.max_abs_between"] = figure_text(facts.max_abs_between);
    metadata["splitsum.max_abs_in_rim"] = figure_text(facts.max_abs_in_rim);
}

void read_cubemap(MetadataReader& reader, AssetFacts& facts) {
    facts.orientation.convention = reader.text("splitsum.convention");
    facts.orientation.rotate_degrees = reader.number<double>("splitsum.rotate_degrees");
    facts.orientation.mirror = reader.flag("splitsum.mirror");
    facts.source.exposure_stops = reader.number<double>("splitsum.exposure_stops");
    facts.source.name = reader.text("splitsum.source");
    facts.source.hash = reader.text("splitsum.source_hash");
    facts.source.color_space = reader.text("splitsum.source_color_space");
    facts.source.repaired_texels = reader.number<long>("splitsum.repaired_texels");
    facts.filter.method = reader.text("splitsum.method");
    facts.filter.accuracy = reader.number<double>("splitsum.accuracy");
    facts.filter.samples = reader.number<int>("splitsum.samples");
    facts.filter.rotate_samples = reader.flag("splitsum.rotate_samples");
    facts.filter.seed = reader.number<uint32_t>("splitsum.seed");
    if (reader.has("splitsum.sequence"))
        facts.filter.sequence = reader.named("splitsum.sequence", point_sequences());
    if (reader.has("splitsum.heuristic"))
        facts.filter.heuristic = reader.named("splitsum.heuristic", mis_heuristics());
}

void read_specular(MetadataReader& reader, AssetFacts& facts) {
    facts.perceptual_roughness = reader.numbers("splitsum.perceptual_roughness");
    const std::string name = reader.text("splitsum.roughness_curve");
    facts.curve = {RoughnessCurve::Kind::list, facts.perceptual_roughness};
    if (name == "linear") facts.curve = {RoughnessCurve::Kind::linear, {}};
    if (name == "filament") facts.curve = {RoughnessCurve::Kind::filament, {}};
}

SmithTerm geometry_named(std::string_view name) {
    for (const SmithTermInfo& info : smith_terms())
        if (info.name == name) return info.term;
    return smith_terms().front().term;
}

void read_table(MetadataReader& reader, TableFacts& facts) {
    TablePlan& plan = facts.plan;
    plan.kind = reader.text("splitsum.table");
    facts.value = reader.text("splitsum.value");
    facts.view_axis = reader.text("splitsum.view_axis");
    plan.axes = reader.named("splitsum.axes_order", table_axes());
    plan.layout = reader.named("splitsum.layout", texel_layouts());
    plan.roughness_axis = reader.named("splitsum.roughness_axis", roughness_axes());
    plan.flip = reader.flag("splitsum.flip");
    facts.has_geometry = reader.has("splitsum.geometry");
    if (facts.has_geometry) plan.geometry = geometry_named(reader.text("splitsum.geometry"));
    plan.method = reader.text("splitsum.method");
    plan.samples = reader.number<int>("splitsum.samples");
    facts.max_abs = reader.number<double>("splitsum.max_abs");
    facts.max_abs_between = reader.number<double>("splitsum.max_abs_between");
    facts.max_abs_in_rim = reader.number<double>("splitsum.max_abs_in_rim");
}

}  // namespace

double stored_factor(const AssetFacts& facts) {
    return facts.kind == AssetFacts::Kind::irradiance && facts.stores_irradiance ? std::numbers::pi
                                                                                 : 1;
}

std::map<std::string, std::string> metadata_of(const AssetFacts& facts) {
    Metadata metadata;
    metadata["splitsum.asset"] = kind_names[size_t(facts.kind)];
    metadata["splitsum.version"] = version;
    if (facts.kind != AssetFacts::Kind::table) describe_cubemap(facts, metadata);
    if (facts.kind == AssetFacts::Kind::specular) describe_specular(facts, metadata);
    if (facts.kind == AssetFacts::Kind::irradiance)
        metadata["splitsum.value"] = facts.stores_irradiance ? "irradiance" : "irradiance / pi";
    if (facts.kind == AssetFacts::Kind::table) describe_table(facts.table, metadata);
    return metadata;
}

Result<AssetFacts> facts_of(const Metadata& metadata) {
    MetadataReader reader(metadata);
    AssetFacts facts;
    const std::string name = reader.text("splitsum.asset");
    const auto kind = std::ranges::find(kind_names, name);
    if (kind == kind_names.end())
        return Error{ErrorKind::unusable_input,
                     name.empty() ? reader.problem() : cat("an asset of kind '", name, "'")};
    facts.kind = AssetFacts::Kind(kind - kind_names.begin());
    if (facts.kind == AssetFacts::Kind::table)
        read_table(reader, facts.table);
    else
        read_cubemap(reader, facts);
    if (facts.kind == AssetFacts::Kind::specular) read_specular(reader, facts);
    if (facts.kind == AssetFacts::Kind::irradiance)
        facts.stores_irradiance = reader.text("splitsum.value") == "irradiance";
    if (!reader.problem().empty()) return Error{ErrorKind::unusable_input, reader.problem()};
    return facts;
}

}  // namespace splitsum
