#include "common/options.h"

#include <algorithm>
#include <limits>
#include <map>

#include "splitsum/base/text.h"
#include "splitsum/brdf/smith.h"
#include "splitsum/table/kinds.h"
#include "splitsum/table/split_sum.h"

namespace splitsum::tools {
namespace {

constexpr int largest_size = 8192;
constexpr int most_samples = 1 << 24;

template <class Value>
std::string with_default(const std::string& text, const Value& value) {
    return cat(text, " (default ", value, ")");
}

template <class Integer>
void add_whole(CLI::App& app, const std::string& name, Integer& value, int64_t lowest,
               int64_t highest, const std::string& unit, const std::string& text) {
    app.add_option(name, value, cat(text, ", ", lowest, " to ", highest, " (default ", value, ")"))
        ->option_text(unit)
        ->check(whole_number(lowest, highest));
}

CLI::Option* add_number(CLI::App& app, const std::string& name, double& value, double limit,
                        const std::string& unit, const std::string& text,
                        const std::string& fallback) {
    return app
        .add_option(name, value, with_default(text, fallback.empty() ? cat(value) : fallback))
        ->option_text(unit)
        ->check(finite_number(-limit, limit));
}

CLI::Option* add_choice(CLI::App& app, const std::string& name, std::string& value,
                        const std::vector<Choice>& choices, const std::string& text,
                        const std::string& fallback = "") {
    const std::string described = with_default(text, fallback.empty() ? value : fallback);
    return app.add_option(name, value, cat(described, "\n", help_of(choices)))
        ->option_text("NAME")
        ->check(one_of(choices));
}

// A choice among named values that ends in `value`, whose present name is the default.
template <class Value>
void add_named_value(CLI::App& app, const std::string& name, Value& value,
                     std::span<const NamedValue<Value>> rows, const std::string& text) {
    const std::vector<Choice> choices = choices_of(rows);
    const auto store = [&value, rows](const std::string& given) {
        value = *value_named(rows, given);
    };
    app.add_option_function<std::string>(
           name, store, cat(with_default(text, name_of(rows, value)), "\n", help_of(choices)))
        ->option_text("NAME")
        ->check(one_of(choices));
}

std::vector<Choice> formats_for(EncodingOptions::Content content) {
    std::vector<Choice> choices;
    const auto holds = content == EncodingOptions::Content::table ? holds_tables : holds_colours;
    for (const PixelFormatInfo& format : pixel_formats())
        if (holds(format)) choices.push_back({format.name, format.summary});
    return choices;
}

// What --help names as the default of an option that kinds of tables differ in: "a; b of x and y".
template <class Text>
std::string default_of_kinds(const Text& text_of) {
    const std::string usual = text_of(default_plan(table_kinds().front()));
    std::map<std::string, std::vector<std::string_view>> others;
    for (const TableKind& kind : table_kinds()) {
        const std::string text = text_of(default_plan(kind));
        if (text != usual && !kind.is_closed_form()) others[text].push_back(kind.name);
    }
    std::string text = usual;
    for (const auto& [other, names] : others)
        text += cat("; ", other, " of ", join(names, " and "));
    return text;
}

// Of a name that --table accepts.
TablePlan plan_of_kind(std::string_view name) {
    return default_plan(*std::ranges::find(table_kinds(), name, &TableKind::name));
}

}  // namespace

ReadingOptions::ReadingOptions(CLI::App& app, const std::string& fallback, Exposure exposure) {
    app.add_option("--colorspace", plan_.color_space,
                   "colour space of the file (default: what the file says, else scene-linear "
                   "Rec.709)")
        ->option_text("NAME")
        ->check(not_empty());
    app.add_option("--ocio-config", ocio_config_,
                   "OpenColorIO configuration (default: $OCIO, else the built-in one)")
        ->option_text("FILE")
        ->envname("OCIO");
    app.add_option("--layer", plan_.layer,
                   "layer of an EXR file (default: the one without a name, else the only one)")
        ->option_text("NAME")
        ->check(not_empty());
    if (exposure == Exposure::option)
        exposure_ = add_number(app, "--exposure", plan_.exposure_stops, 64, "STOPS",
                               "multiply radiance by 2^STOPS, -64 to 64", fallback);
    app.add_flag(
        "--repair", plan_.repair,
        "replace NaN and Inf by their neighbours' mean and negative values by 0, and count "
        "them (default: refuse the file)");
}

PanoramaOptions ReadingOptions::plan() const {
    PanoramaOptions plan = plan_;
    plan.ocio_config = ocio_config_;
    return plan;
}

InputOptions::InputOptions(CLI::App& app, Count count) : reading_(app) {
    auto* inputs =
        app.add_option("PANORAMA", panoramas, "a 2:1 lat-long image: .exr, .hdr, .tif, .pfm, ...");
    inputs->option_text(count == Count::many ? "..." : " ")->required()->check(not_empty());
    if (count == Count::one) inputs->expected(1);
}

OrientationOptions::OrientationOptions(CLI::App& app, const std::string& fallback) {
    options_ = {add_number(app, "--rotate", plan.rotate_degrees, 36000, "DEGREES",
                           "turn the panorama about +y, its middle towards +X", fallback),
                app.add_flag("--mirror", plan.mirror,
                             "swap left and right of the panorama, before it is turned"),
                add_choice(app, "--convention", plan.convention, choices_of(conventions()),
                           "how the panorama is laid around the cube", fallback)};
}

bool OrientationOptions::given() const {
    return std::ranges::any_of(options_, [](const CLI::Option* o) { return o->count() > 0; });
}

FilterOptions::FilterOptions(CLI::App& app, const std::vector<Choice>& methods) {
    add_choice(app, "--method", plan.method, methods, "how light is integrated");
    app.add_option("--accuracy", plan.accuracy,
                   with_default("relative error (rel_rms of a level) that auto and spectral may "
                                "make, 1e-5 to 0.1",
                                plan.accuracy))
        ->option_text("ERROR")
        ->check(finite_number(1e-5, 0.1));
    add_whole(app, "--samples", plan.samples, 1, most_samples, "COUNT",
              "directions per texel, for methods that sample");
    add_named_value(app, "--sequence", plan.sequence, point_sequences(),
                    "which points importance, filtered and mis draw");
    add_named_value(app, "--heuristic", plan.heuristic, mis_heuristics(),
                    "how mis weighs a direction that lobe and light could both draw");
    app.add_flag(
        "--rotate-samples", plan.rotate_samples,
        "turn the directions by a different angle at each texel: noise instead of patterns");
    add_whole(app, "--seed", plan.seed, 0, std::numeric_limits<uint32_t>::max(), "NUMBER",
              "chooses the angles of --rotate-samples, random points and the points of mis");
}

SpecularOptions::SpecularOptions(CLI::App& app) {
    add_whole(app, "--size", plan_.face_size, 1, largest_size, "TEXELS",
              "texels along an edge of level 0");
    add_whole(app, "--levels", plan_.levels, 1, 14, "COUNT",
              "mip levels, at most down to faces of one texel");
    app.add_option(
           "--roughness", roughness_,
           with_default("perceptual roughness of the levels: linear (level / (levels - 1)), "
                        "filament\n(1 - sqrt(1 - level / (levels - 1))), babylon (sqrt(2^(level / "
                        "0.8) / size - 0.0005),\nat most 1) or a list such as 0,0.25,0.5,1",
                        roughness_))
        ->option_text("CURVE")
        ->check(not_empty());
}

Result<SpecularPlan> SpecularOptions::plan() const {
    SpecularPlan plan = plan_;
    const auto curve = parse_roughness_curve_of_chain(roughness_, plan.face_size, plan.levels);
    if (!curve) return curve.error();
    plan.roughness = *curve;
    if (const Status valid = validate(plan); !valid) return valid.error();
    return plan;
}

IrradianceOptions::IrradianceOptions(CLI::App& app, const std::string& prefix) {
    add_whole(app, cat("--", prefix, "size"), plan.face_size, 1, largest_size, "TEXELS",
              "texels along an edge of the irradiance cubemap");
    add_whole(app, cat("--", prefix, "order"), plan.harmonics_order, 0, 128, "BAND",
              "order of the harmonics (order 2 has 9 coefficients)");
    app.add_flag(cat("--", prefix, "window"), plan.windowed,
                 "damp the higher bands until no direction is negative under a sun (Sloan 2008)");
    app.add_flag(cat("--", prefix, "store-e"), plan.store_irradiance,
                 "store E itself instead of E / pi");
}

TableOptions::TableOptions(CLI::App& app, const std::string& prefix)
    : geometry_(info_of(plan_.geometry).name), roughness_axis_(roughness_axes().front().name) {
    const auto named = [&](const char* name) { return cat("--", prefix, name); };
    add_choice(app, prefix.empty() ? "--table" : named("kind"), plan_.kind,
               choices_of(table_kinds()), "what the table holds");
    add_choice(app, named("method"), plan_.method, choices_of(split_sum_methods()),
               "how light is integrated");
    accuracy_given_ =
        app.add_option(named("accuracy"), accuracy_,
                       "largest error (max_abs) that the stored texels may have, 1e-7 to 0.1, and "
                       "with\nan automatic size lookups between them too (default: exact to 1e-7 "
                       "before the format rounds)")
            ->option_text("ERROR")
            ->check(finite_number(1e-7, 0.1));
    add_whole(app, named("samples"), plan_.samples, 1, most_samples, "COUNT",
              "sample points per texel, for methods that sample");
    size_given_ =
        app.add_option(
               named("size"), size_,
               cat("texels along an edge, 1 to ", largest_size, ", or auto: the smallest of ",
                   smallest_automatic_size, ", 16, ... ", largest_automatic_size, " that meets ",
                   named("accuracy"), " (default ",
                   default_of_kinds([](const TablePlan& plan) { return cat(plan.size); }), ")"))
            ->option_text("TEXELS")
            ->check(whole_number_or_auto(1, largest_size));
    layout_given_ = add_choice(app, named("layout"), layout_, choices_of(texel_layouts()),
                               "where texels sit", default_of_kinds([](const TablePlan& plan) {
                                   return std::string(name_of(texel_layouts(), plan.layout));
                               }));
    axes_given_ =
        add_choice(app, named("axes"), axes_, choices_of(table_axes()), "what goes right and down",
                   default_of_kinds([](const TablePlan& plan) {
                       return std::string(name_of(table_axes(), plan.axes));
                   }));
    add_choice(app, named("roughness-axis"), roughness_axis_, choices_of(roughness_axes()),
               "what the roughness axis counts in");
    app.add_flag(named("flip"), plan_.flip, "rows from 1 down to 0 instead of from 0 up to 1");
    add_choice(app, named("geometry"), geometry_, choices_of(smith_terms()),
               "shadowing and masking of the microfacets");
}

TablePlan TableOptions::plan() const {
    TablePlan plan = plan_;
    const TablePlan usual = plan_of_kind(plan_.kind);
    plan.size = size_given_->count() == 0 ? usual.size
                : size_ == "auto"         ? TablePlan::automatic_size
                                          : std::stoi(size_);
    if (accuracy_given_->count() > 0) plan.accuracy = accuracy_;
    for (const SmithTermInfo& info : smith_terms())
        if (info.name == geometry_) plan.geometry = info.term;
    plan.layout =
        layout_given_->count() > 0 ? *value_named(texel_layouts(), layout_) : usual.layout;
    plan.axes = axes_given_->count() > 0 ? *value_named(table_axes(), axes_) : usual.axes;
    plan.roughness_axis = *value_named(roughness_axes(), roughness_axis_);
    return plan;
}

std::string container_endings() {
    return join(containers(), " or ", [](const Container& c) { return c.extension; });
}

EncodingOptions::EncodingOptions(CLI::App& app, Content content, const std::string& prefix)
    : format_(content == Content::table ? "rg16f" : "rgba16f") {
    const bool table = content == Content::table;
    format_given_ = add_choice(
        app, cat("--", prefix, "format"), format_, formats_for(content),
        table ? "how a texel is stored" : "how a texel is stored in a .ktx2 file",
        table
            ? "rg16f, of 4 channels rgba16f; rg32f of energy and energy-lost; rg32f and rgba32f in "
              "source"
            : "");
    auto* zstd = app.add_flag(cat("--", prefix, "zstd"), container_.ktx2.zstd,
                              "supercompress a .ktx2 file with Zstandard");
    app.add_option(
           cat("--", prefix, "zstd-level"), container_.ktx2.zstd_level,
           with_default("with --zstd, 1 (fastest) to 22 (smallest)", container_.ktx2.zstd_level))
        ->option_text("LEVEL")
        ->check(whole_number(1, 22))
        ->needs(zstd);
}

PixelFormat EncodingOptions::format() const { return find_pixel_format(format_)->format; }

OutputOptions::OutputOptions(CLI::App& app, const std::string& placeholder,
                             const std::string& text) {
    app.add_option("-o,--output", path_, text + " (required)")
        ->option_text(placeholder)
        ->required()
        ->check(not_empty());
}

JsonOption::JsonOption(CLI::App& app) { app.add_flag("--json", json, "print the results as JSON"); }

}  // namespace splitsum::tools
