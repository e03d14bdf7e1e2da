#include "splitsum/report/asset_facts.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

#include "splitsum/base/text.h"
#include "splitsum/base/version.h"

namespace splitsum {
namespace {

using Metadata = std::map<std::string, std::string>;

constexpr std::array<std::string_view, 3> kind_names = {"specular", "irradiance", "split-sum"};

template <class Number>
std::string number_text(Number value) {  // the shortest text that reads back to the same number
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    return {digits.data(), end};
}

std::string flag_text(bool flag) { return flag ? "true" : "false"; }

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

void describe_table(const TablePlan& plan, Metadata& metadata) {
    metadata["splitsum.value"] = "split sum: albedo = F0 * red + green";
    metadata["splitsum.axes"] = "x = n.v, y = perceptual roughness, texel centres, row 0 lowest";
    metadata["splitsum.geometry"] = info_of(plan.geometry).name;
    metadata["splitsum.samples"] = number_text(plan.samples);
}

// Reads values from the metadata; remembers the first that could not be read.
class Reader {
public:
    explicit Reader(const Metadata& metadata) : metadata_(metadata) {}

    std::string text(const std::string& key) {
        const auto found = metadata_.find(key);
        if (found != metadata_.end()) return found->second;
        if (problem_.empty()) problem_ = cat("the file does not say '", key, "'");
        return {};
    }

    template <class Number>
    Number number(const std::string& key) {
        return parsed<Number>(key, text(key));
    }

    bool flag(const std::string& key) { return text(key) == "true"; }

    std::vector<double> numbers(const std::string& key) {
        std::vector<double> values;
        std::istringstream words(text(key));
        for (std::string word; words >> word;) values.push_back(parsed<double>(key, word));
        return values;
    }

    const std::string& problem() const { return problem_; }

private:
    template <class Number>
    Number parsed(const std::string& key, const std::string& word) {
        Number value{};
        const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
        const bool whole = result.ec == std::errc() && result.ptr == word.data() + word.size();
        if (!whole && problem_.empty())
            problem_ = cat("the file says '", word, "' for '", key, "', which is not a number");
        return value;
    }

    const Metadata& metadata_;
    std::string problem_;
};

void read_cubemap(Reader& reader, AssetFacts& facts) {
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
}

void read_specular(Reader& reader, AssetFacts& facts) {
    facts.perceptual_roughness = reader.numbers("splitsum.perceptual_roughness");
    const std::string name = reader.text("splitsum.roughness_curve");
    facts.curve = {RoughnessCurve::Kind::list, facts.perceptual_roughness};
    if (name == "linear") facts.curve = {RoughnessCurve::Kind::linear, {}};
    if (name == "filament") facts.curve = {RoughnessCurve::Kind::filament, {}};
}

void read_table(Reader& reader, AssetFacts& facts) {
    facts.table.samples = reader.number<int>("splitsum.samples");
    const std::string geometry = reader.text("splitsum.geometry");
    for (const SmithTermInfo& info : smith_terms())
        if (info.name == geometry) facts.table.geometry = info.term;
}

}  // namespace

std::map<std::string, std::string> metadata_of(const AssetFacts& facts) {
    Metadata metadata;
    metadata["splitsum.asset"] = kind_names[size_t(facts.kind)];
    metadata["splitsum.version"] = version;
    if (facts.kind != AssetFacts::Kind::split_sum) describe_cubemap(facts, metadata);
    if (facts.kind == AssetFacts::Kind::specular) describe_specular(facts, metadata);
    if (facts.kind == AssetFacts::Kind::irradiance)
        metadata["splitsum.value"] = facts.stores_irradiance ? "irradiance" : "irradiance / pi";
    if (facts.kind == AssetFacts::Kind::split_sum) describe_table(facts.table, metadata);
    return metadata;
}

Result<AssetFacts> facts_of(const Metadata& metadata) {
    Reader reader(metadata);
    AssetFacts facts;
    const std::string name = reader.text("splitsum.asset");
    const auto kind = std::ranges::find(kind_names, name);
    if (kind == kind_names.end())
        return Error{ErrorKind::unusable_input,
                     name.empty() ? reader.problem() : cat("an asset of kind '", name, "'")};
    facts.kind = AssetFacts::Kind(kind - kind_names.begin());
    if (facts.kind == AssetFacts::Kind::split_sum)
        read_table(reader, facts);
    else
        read_cubemap(reader, facts);
    if (facts.kind == AssetFacts::Kind::specular) read_specular(reader, facts);
    if (facts.kind == AssetFacts::Kind::irradiance)
        facts.stores_irradiance = reader.text("splitsum.value") == "irradiance";
    if (!reader.problem().empty()) return Error{ErrorKind::unusable_input, reader.problem()};
    return facts;
}

}  // namespace splitsum
