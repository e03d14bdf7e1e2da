#include "preview_options.h"

#include <charconv>

#include "splitsum/base/text.h"
#include "splitsum/preview/auto_yaw.h"
#include "splitsum/preview/scene_file.h"
#include "splitsum/preview/view.h"

namespace splitsum::tools {
namespace {

constexpr int largest_size = 8192;

// "1024x512" as numbers from 1 to largest_size.
std::optional<std::pair<int, int>> parse_size(const std::string& text) {
    const char* const end = text.data() + text.size();
    int width = 0, height = 0;
    const auto [cross, first] = std::from_chars(text.data(), end, width);
    if (first != std::errc{} || cross == end || *cross != 'x') return std::nullopt;
    const auto [last, second] = std::from_chars(cross + 1, end, height);
    if (second != std::errc{} || last != end) return std::nullopt;
    if (std::min(width, height) < 1 || std::max(width, height) > largest_size) return std::nullopt;
    return std::pair(width, height);
}

CLI::Validator picture_size() {
    return CLI::Validator(
        [](std::string& text) -> std::string {
            if (parse_size(text)) return {};
            return cat("'", text, "' is not a size such as 1024x512, 1 to ", largest_size,
                       " pixels wide and high");
        },
        "");
}

// A finite number of `what` within the limit, or "auto".
CLI::Validator auto_or_number(double limit, const std::string& what) {
    const CLI::Validator number = finite_number(-limit, limit);
    return CLI::Validator(
        [=](std::string& text) -> std::string {
            if (text == "auto" || number(text).empty()) return {};
            return cat("'", text, "' is neither auto nor a number of ", what, " from -", limit,
                       " to ", limit);
        },
        "");
}

void add_file(CLI::App& app, const std::string& name, std::string& value, const std::string& text) {
    app.add_option(name, value, text)->option_text("FILE")->check(not_empty());
}

std::vector<Choice> view_choices() { return choices_of(views()); }

}  // namespace

AssetOptions::AssetOptions(CLI::App& app) {
    app.add_option("BAKED", folder_, "a folder that splitsum-bake wrote: DIR/<panorama>")
        ->option_text(" ")
        ->check(not_empty());
    add_file(app, "--specular", specular_, "the prefiltered levels (default BAKED/specular.ktx2)");
    add_file(app, "--irradiance", irradiance_,
             "the diffuse light: a cubemap, or harmonics as .json (default BAKED/irradiance.ktx2)");
    add_file(app, "--table", table_,
             "the split-sum table (default the nearest brdf.ktx2 in BAKED or above it)");
}

Result<BakedFiles> AssetOptions::files() const {
    BakedFiles files;
    if (!folder_.empty()) files = files_of_bake(folder_);
    if (!specular_.empty()) files.specular = specular_;
    if (!irradiance_.empty()) files.irradiance = irradiance_;
    if (!table_.empty()) files.table = table_;
    if (files.specular.empty() || files.irradiance.empty() || files.table.empty())
        return Error{
            ErrorKind::bad_argument,
            "BAKED is required, a folder such as out/sunset that splitsum-bake wrote, or all "
            "of --specular, --irradiance and --table"};
    return files;
}

SceneOptions::SceneOptions(CLI::App& app) {
    add_file(
        app, "--scene", file_,
        "the objects to show, see below (default: seven dielectrics over seven metals, perceptual "
        "roughness 0 to 1)");
    app.add_option_function<std::string>(
           "--size",
           [this](const std::string& text) {
               const auto size = *parse_size(text);
               viewpoint_.width = size.first;
               viewpoint_.height = size.second;
           },
           "pixels of each picture (default 1024x512)")
        ->option_text("WIDTHxHEIGHT")
        ->check(picture_size());
    app.add_option("--yaw", yaw_,
                   "turn the view about +y, from +z towards +x, -36000 to 36000 (default 0); auto: "
                   "until most\nlight comes from the left")
        ->option_text("DEGREES|auto")
        ->check(auto_or_number(36000, "degrees"));
    app.add_option("--pitch", viewpoint_.pitch_degrees,
                   "then look up by this, -90 to 90 (default 0)")
        ->option_text("DEGREES")
        ->check(finite_number(-90, 90));
    app.add_flag("--background,!--no-background", background_,
                 "show the light behind the objects (the default), or black");
}

Viewpoint SceneOptions::viewpoint(const Cubemap& irradiance) const {
    Viewpoint viewpoint = viewpoint_;
    viewpoint.yaw_degrees = yaw_ == "auto" ? auto_yaw_degrees(irradiance) : std::stod(yaw_);
    return viewpoint;
}

Result<Scene> SceneOptions::scene() const {
    return file_.empty() ? textbook_scene() : read_scene(file_);
}

std::string SceneOptions::note() const {
    if (!file_.empty())
        return cat("The objects of ", std::filesystem::path(file_).filename().string(), ".");
    return "Above dielectrics, below metals, perceptual roughness 0 to 1 from left to right.";
}

ViewOptions::ViewOptions(CLI::App& app) : name(views().front().name) {
    app.add_option(
           "--view", name,
           cat("how a PNG is shown (default ", name,
               "), or display/view of the OpenColorIO configuration\n", help_of(view_choices())))
        ->option_text("NAME")
        ->check(not_empty());
    app.add_option("--exposure", exposure_,
                   "multiply what a PNG shows by 2^STOPS, -64 to 64 (default auto: by the light)")
        ->option_text("auto|STOPS")
        ->check(auto_or_number(64, "stops"));
}

std::optional<double> ViewOptions::exposure_stops() const {
    if (exposure_ == "auto") return std::nullopt;
    return std::stod(exposure_);
}

TruthOptions::TruthOptions(CLI::App& app) {
    auto* file = app.add_option("--panorama", panorama,
                                "the panorama that was baked: what the assets are measured against")
                     ->option_text("FILE")
                     ->check(not_empty());
    auto* drawn =
        app.add_flag("--truth", truth,
                     "draw the same by exact integration too, without splitting anything, "
                     "and the\ndifference: white where there is none, red where baked "
                     "light is brighter, blue\nwhere it is darker, fully so at 25 %")
            ->option_text(" ")
            ->needs(file);
    app.add_option(
           "--noise", plan_.noise,
           cat("with --truth, the mean relative standard error to reach, 1e-4 to 1 (default ",
               plan_.noise, ")"))
        ->option_text("SHARE")
        ->check(finite_number(1e-4, 1))
        ->needs(drawn);
    app.add_option("--time-limit", plan_.seconds,
                   "with --truth, draw for no longer than this, whatever the noise; then the "
                   "picture depends\non the machine, 0 to 1e6 (default 0: no limit)")
        ->option_text("SECONDS")
        ->check(finite_number(0, 1e6))
        ->needs(drawn);
    app.add_flag("--verify,!--no-verify", verify_,
                 "with --panorama, measure the assets (the default), or do not");
    app.add_option("--probes", probes_,
                   cat("texels per level that are measured (default ", probes_, ")"))
        ->option_text("COUNT")
        ->check(whole_number(1, 1 << 24));
}

PreviewOptions::PreviewOptions(CLI::App& app)
    : assets(app),
      output(app, "FILE", "the picture: .png, or .exr for scene-linear light"),
      truth(app),
      scene(app),
      view(app),
      reading(app, "", ReadingOptions::Exposure::none),
      page(app),
      json(app) {}

}  // namespace splitsum::tools
