#include "comparison.h"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "asset_file.h"
#include "certificate_check.h"
#include "light/asset_source.h"
#include "light/cubemap_tool.h"
#include "limits.h"
#include "splitsum/bake/facts.h"
#include "splitsum/base/text.h"
#include "splitsum/report/figures_json.h"
#include "splitsum/report/figures_text.h"

namespace splitsum::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* what_the_asset_says = "what the asset says";

struct Comparison {
    std::vector<LevelCheck> levels;
    std::vector<std::string> notes;
    std::optional<CertificateCheck> certificate;
    std::vector<ReconstructionError> between{};
};

Error mismatch(const std::string& what) { return {ErrorKind::unusable_input, what}; }

// What the file says of itself, completed and overruled by what the user says.
Result<AssetFacts> facts_with_options(const AssetFile& file, const CompareOptions& options) {
    if (file.table) return mismatch(cat(options.asset, " is a table, which no panorama has made"));
    if (!file.facts && options.kind.empty())
        return mismatch(cat(options.asset,
                            " does not say what it holds; say --as specular or --as irradiance"));
    AssetFacts facts = file.facts.value_or(AssetFacts{});
    if (options.kind == "specular") facts.kind = AssetFacts::Kind::specular;
    if (options.kind == "irradiance") facts.kind = AssetFacts::Kind::irradiance;
    if (options.orientation.given() || !file.facts) facts.orientation = options.orientation.plan;
    const bool is_chain = facts.kind == AssetFacts::Kind::specular;
    if (is_chain && (!options.roughness.empty() || facts.perceptual_roughness.empty())) {
        const auto curve = parse_roughness_curve_of_chain(
            options.roughness.empty() ? "linear" : options.roughness,
            file.levels.empty() ? 1 : file.levels.front().face_size, int(file.levels.size()));
        if (!curve) return curve.error();
        facts.curve = *curve;
        // A list says how many levels it is for; the curves fit any number.
        facts.perceptual_roughness = curve->kind == RoughnessCurve::Kind::list
                                         ? curve->list
                                         : roughness_of_levels(*curve, int(file.levels.size()));
    }
    if (is_chain && facts.perceptual_roughness.size() != file.levels.size())
        return mismatch(cat(options.asset, " has ", file.levels.size(), " levels and names ",
                            facts.perceptual_roughness.size(), " roughness values"));
    return facts;
}

// Whether the asset would be measured as something else than it was made to be.
bool overruled(const CompareOptions& options) {
    return options.orientation.given() || options.reading.exposure_given() ||
           !options.kind.empty() || !options.roughness.empty();
}

Result<Comparison> against_panorama(const AssetFile& file, const CompareOptions& options,
                                    Progress& progress) {
    const auto facts = facts_with_options(file, options);
    if (!facts) return facts.error();
    const auto source = read_asset_source(options.panorama, file.facts, options.reading, progress);
    if (!source) return source.error();
    const Environment environment(source->panorama.pixels);

    Comparison comparison;
    comparison.notes = source->notes;
    if (file.harmonics) {
        const auto check = check_harmonics(
            *file.harmonics, {environment, panorama_from_cube(facts->orientation), options.probes},
            progress);
        if (!check) return check.error();
        comparison.levels = {*check};
        return comparison;
    }
    auto levels = check_cubemap_asset(file.levels, *facts, environment, options.probes, progress);
    if (!levels) return levels.error();
    comparison.levels = std::move(*levels);
    auto between = check_readings(file.levels, *facts, environment, options.probes, progress);
    if (!between) return between.error();
    comparison.between = std::move(*between);
    const bool as_made = source->is_source && !overruled(options);
    auto certificate = check_certificate(file, *facts, as_made ? &environment : nullptr, progress);
    if (!certificate) return certificate.error();
    comparison.certificate = std::move(*certificate);
    if (!comparison.certificate)
        comparison.notes.push_back("the asset carries no certificate");
    else if (!as_made)
        comparison.notes.push_back(
            "certified figures are of another panorama or other options, and were not measured "
            "again");
    return comparison;
}

// The file alone: is it what it says of itself?
Result<Comparison> against_itself(const AssetFile& file, const CompareOptions& options,
                                  Progress& progress) {
    if (file.table || file.harmonics)
        return mismatch(cat(options.asset, file.table ? " is a table" : " is a series of harmonics",
                            ", which carries no certificate; say what to compare it with: ",
                            file.table ? "another table" : "another series or --panorama FILE"));
    const auto facts = facts_with_options(file, options);
    if (!facts) return facts.error();
    auto certificate = check_certificate(file, *facts, nullptr, progress);
    if (!certificate) return certificate.error();
    if (!*certificate)
        return mismatch(
            cat(options.asset,
                " carries no certificate: an older version or another program wrote it; "
                "--panorama FILE measures it"));
    return Comparison{
        (*certificate)->levels,
        {"the figures are those of the certificate; --panorama FILE measures them again"},
        std::move(*certificate)};
}

Result<Comparison> tables_compared(const Table& table, const Table& other) {
    const auto shape = [](const Table& of) {
        return cat(of.width, "x", of.height, " texels, ", of.channels, " channels and ", of.layers,
                   " layers");
    };
    if (shape(table) != shape(other))
        return mismatch(
            cat("the tables have ", shape(table), ", and ", shape(other), "; they must be equal"));
    LevelCheck check;
    check.face_size = table.width;
    check.figures = error_figures(table.values, other.values, table.channels);
    return Comparison{{check}, {}, {}};
}

Result<Comparison> cubemaps_compared(const AssetFile& file, const AssetFile& other) {
    if (file.levels.size() != other.levels.size() ||
        file.levels[0].face_size != other.levels[0].face_size)
        return mismatch(cat("the cubemaps have ", file.levels.size(), " levels from ",
                            file.levels[0].face_size, "² and ", other.levels.size(),
                            " levels from ", other.levels[0].face_size, "²; they must be equal"));
    Comparison comparison;
    for (size_t level = 0; level < file.levels.size(); ++level) {
        LevelCheck check;
        check.level = int(level);
        check.face_size = file.levels[level].face_size;
        if (file.facts && level < file.facts->perceptual_roughness.size())
            check.perceptual_roughness = file.facts->perceptual_roughness[level];
        check.figures = error_figures(std::span(file.levels[level].texels),
                                      std::span(other.levels[level].texels));
        check.mean_radiance = mean_radiance(file.levels[level]);
        comparison.levels.push_back(check);
    }
    return comparison;
}

Result<Comparison> against_asset(const AssetFile& file, const CompareOptions& options) {
    const auto other = read_asset(options.other);
    if (!other) return other.error();
    if (file.table && other->table) return tables_compared(*file.table, *other->table);
    if (!file.levels.empty() && !other->levels.empty()) return cubemaps_compared(file, *other);
    if (file.harmonics && other->harmonics) {
        std::vector<Vec3> a, b;
        for (const Vec3d& c : file.harmonics->coefficients) a.emplace_back(c);
        for (const Vec3d& c : other->harmonics->coefficients) b.emplace_back(c);
        if (a.size() != b.size())
            return mismatch(cat("the series have ", a.size(), " and ", b.size(), " coefficients"));
        LevelCheck check;
        check.figures = error_figures(std::span<const Vec3>(a), std::span<const Vec3>(b));
        return Comparison{{check}, {}, {}};
    }
    return mismatch(cat(options.asset, " and ", options.other, " are of different kinds"));
}

Result<Comparison> compared(const AssetFile& file, const CompareOptions& options,
                            Progress& progress) {
    if (!options.panorama.empty()) return against_panorama(file, options, progress);
    if (!options.other.empty()) return against_asset(file, options);
    return against_itself(file, options, progress);
}

Json certificate_json(const std::optional<CertificateCheck>& certificate) {
    if (!certificate) return nullptr;
    return {{"holds", certificate->contradictions.empty()},
            {"measured", certificate->measured},
            {"contradictions", certificate->contradictions}};
}

std::string certificate_text(const CertificateCheck& certificate) {
    std::string text;
    for (const std::string& line : certificate.contradictions)
        text += cat("certificate: ", line, "\n");
    if (!text.empty()) return text;
    return cat("certificate: holds for the texels, their means and the keys",
               certificate.measured ? ", and for the figures, measured again\n" : "\n");
}

void print(const Comparison& comparison, const std::vector<std::string>& over, bool json) {
    if (json) {
        Json result;
        result["notes"] = comparison.notes;
        result["levels"] = Json::array();
        for (const LevelCheck& check : comparison.levels)
            result["levels"].push_back(check_json(check));
        if (!comparison.between.empty())
            result["between_texels_and_levels"] = readings_json(comparison.between);
        result["over_limit"] = over;
        result["certificate"] = certificate_json(comparison.certificate);
        std::cout << result.dump(2) << "\n";
        return;
    }
    for (const std::string& note : comparison.notes) std::cout << "note: " << note << "\n";
    std::cout << figures_heading(false);
    for (const LevelCheck& check : comparison.levels)
        std::cout << figures_line(cat("level ", check.level), check);
    if (!comparison.between.empty())
        std::cout << "What an engine reads between texels and levels:\n"
                  << readings_text(comparison.between);
    for (const std::string& line : over) std::cout << line << "\n";
    if (comparison.certificate) std::cout << certificate_text(*comparison.certificate);
}

}  // namespace

CompareOptions::CompareOptions(CLI::App& app)
    : reading(app, what_the_asset_says), orientation(app, what_the_asset_says), json(app) {
    app.add_option("ASSET", asset, "the asset: .ktx2, .exr, .dds, or .json of harmonics")
        ->option_text(" ")
        ->required()
        ->check(not_empty());
    app.add_option("OTHER", other,
                   "an asset to compare with, instead of --panorama; with neither, ASSET is "
                   "checked against its certificate")
        ->option_text(" ")
        ->check(not_empty());
    app.add_option("--panorama", panorama, "the panorama the asset was made from")
        ->option_text("FILE")
        ->check(not_empty());
    app.add_option("--as", kind,
                   "what ASSET holds where the file does not say: specular or irradiance")
        ->option_text("KIND")
        ->check(
            one_of({{"specular", "a prefiltered chain"}, {"irradiance", "a cubemap of E / pi"}}));
    app.add_option("--roughness", roughness,
                   "perceptual roughness of the levels (default what the asset says, else linear)")
        ->option_text("CURVE")
        ->check(not_empty());
    app.add_option("--limit", limits,
                   "exit with 1 if a level exceeds it; FIGURE is rel_rms, max_rel, max_abs or bias "
                   "(either sign); may be repeated")
        ->option_text("FIGURE=X")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    app.add_option("--probes", probes,
                   "texels per level that are measured against the panorama (default 64)")
        ->option_text("COUNT")
        ->check(whole_number(1, 1 << 24));
}

Result<ExitCode> run_compare(const CompareOptions& options, Progress& progress) {
    if (!options.other.empty() && !options.panorama.empty())
        return Error{ErrorKind::bad_argument,
                     "say what to compare with: either another asset or --panorama FILE"};
    std::vector<Limit> limits;
    for (const std::string& text : options.limits) {
        const auto limit = parse_limit(text);
        if (!limit) return limit.error();
        limits.push_back(*limit);
    }
    const auto file = read_asset(options.asset);
    if (!file) return file.error();
    const auto comparison = compared(*file, options, progress);
    if (!comparison) return comparison.error();

    std::vector<std::string> over;
    for (const LevelCheck& check : comparison->levels)
        for (const std::string& line : exceeded(check.figures, limits))
            over.push_back(cat("level ", check.level, ": ", line));
    print(*comparison, over, options.json.json);
    const bool holds = !comparison->certificate || comparison->certificate->contradictions.empty();
    return over.empty() && holds ? ExitCode::done : ExitCode::over_limit;
}

}  // namespace splitsum::tools
