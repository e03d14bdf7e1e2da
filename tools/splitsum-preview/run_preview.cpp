#include "run_preview.h"

#include <cmath>
#include <optional>

#include "light/asset_source.h"
#include "light/cubemap_tool.h"
#include "picture_file.h"
#include "results.h"
#include "splitsum/base/atomic_file.h"
#include "splitsum/base/text.h"
#include "splitsum/preview/auto_exposure.h"
#include "splitsum/preview/difference.h"
#include "splitsum/preview/sphere_errors.h"
#include "splitsum/preview/split_exact.h"

namespace splitsum::tools {
namespace {

/// What is drawn, and how it is shown.
struct Drawing {
    Scene scene;
    Viewpoint viewpoint;
    Camera camera;
    BakedAssets baked;
    Shown shown;
};

Result<Drawing> prepare(const PreviewOptions& options) {
    const auto files = options.assets.files();
    if (!files) return files.error();
    auto view = View::find(options.view.name, options.reading.plan().ocio_config);
    if (!view) return view.error();
    auto scene = options.scene.scene();
    if (!scene) return scene.error();
    auto baked = read_baked(*files);
    if (!baked) return baked.error();
    const double exposure_stops =
        options.view.exposure_stops().value_or(auto_exposure_stops(baked->light.specular.front()));
    const Viewpoint viewpoint = options.scene.viewpoint(baked->light.irradiance);
    const Camera camera = camera_for(*scene, viewpoint);
    return Drawing{std::move(*scene), viewpoint, camera, std::move(*baked),
                   Shown{std::move(*view), exposure_stops}};
}

/// The light that was baked.
struct SourceLight {
    Environment environment;
    std::vector<std::string> notes;
};

Result<std::optional<SourceLight>> read_source(const PreviewOptions& options,
                                               const BakedAssets& baked, Progress& progress) {
    if (options.truth.panorama.empty()) return std::optional<SourceLight>();
    const auto source =
        read_asset_source(options.truth.panorama, baked.facts, options.reading, progress);
    if (!source) return source.error();
    return std::optional(SourceLight{Environment(source->panorama.pixels), source->notes});
}

// Cancelled in the truth, that is as far as it got.
Result<Pictures> draw(const Drawing& drawing, const PreviewOptions& options,
                      const std::optional<SourceLight>& source, Progress& progress) {
    const auto& light = drawing.baked.light;
    const Background background = options.scene.background();
    auto baked = baked_picture(drawing.scene, drawing.camera, light, background, progress);
    if (!baked) return baked.error();
    Pictures pictures{std::move(*baked), std::nullopt, {}, {}};
    if (!options.truth.truth) return pictures;
    pictures.truth = truth_picture(drawing.scene, drawing.camera, source->environment,
                                   panorama_from_cube(drawing.baked.facts.orientation),
                                   options.truth.plan(), progress);
    pictures.truth_image =
        picture_of(*pictures.truth, drawing.scene, drawing.camera, light, background);
    pictures.standard_error = standard_error_of(*pictures.truth);
    return pictures;
}

Error interrupted(const Pictures& pictures, const std::filesystem::path& file) {
    const bool missing = std::isinf(pictures.truth->noise);
    return {ErrorKind::interrupted,
            cat("interrupted; ", file.string(), " has the picture so far, ",
                missing ? std::string("parts of the truth are missing")
                        : cat("with a mean relative standard error of ", pictures.truth->noise))};
}

Result<ChainFigures> measure_chain(const BakedAssets& baked, const Environment& environment,
                                   int probes, Progress& progress) {
    const auto& levels = baked.light.specular;
    auto checks = check_cubemap_asset(levels, baked.facts, environment, probes, progress);
    if (!checks) return checks.error();
    auto between = check_readings(levels, baked.facts, environment, probes, progress);
    if (!between) return between.error();
    return ChainFigures{std::move(*checks), std::move(*between)};
}

std::vector<SphereResult> spheres_in(const Drawing& drawing) {
    std::vector<SphereResult> spheres;
    for (const Sphere& sphere : drawing.scene.spheres) spheres.push_back({sphere, 0});
    for (int y = 0; y < drawing.camera.height; ++y)
        for (int x = 0; x < drawing.camera.width; ++x)
            if (const auto seen = first_surface(drawing.scene, drawing.camera, x, y))
                ++spheres[size_t(seen->sphere)].pixels;
    return spheres;
}

// Separates what the assets cost from what the split sum costs.
Status measure_spheres(const Drawing& drawing, const Environment& environment,
                       const Pictures& pictures, PreviewResults& results, Progress& progress) {
    constexpr int checks = 4;
    const auto exact =
        split_exact(drawing.scene, drawing.camera, environment,
                    panorama_from_cube(drawing.baked.facts.orientation), checks, progress);
    if (!exact) return exact.error();
    const auto errors = sphere_errors(pictures.baked, exact->radiance, *pictures.truth,
                                      int(drawing.scene.spheres.size()));
    for (size_t i = 0; i < errors.size(); ++i) results.spheres[i].errors = errors[i];
    results.truth->split_exact = exact->checked;
    return ok;
}

Result<PreviewResults> measure(const Drawing& drawing, const PreviewOptions& options,
                               const std::optional<SourceLight>& source, const Pictures& pictures,
                               Progress& progress) {
    PreviewResults results;
    results.file = options.output.path();
    results.page = options.page.file;
    results.pictures = picture_names(pictures, results.file);
    results.view = options.view.name;
    results.exposure_stops = drawing.shown.exposure_stops;
    results.yaw_degrees = drawing.viewpoint.yaw_degrees;
    results.notes = drawing.baked.notes;
    results.spheres = spheres_in(drawing);
    if (!source) return results;
    results.notes.insert(results.notes.end(), source->notes.begin(), source->notes.end());
    if (const auto& truth = pictures.truth)
        results.truth = {truth->noise, truth->passes, truth->total_samples, truth->end, {}};
    if (options.truth.probes() == 0) return results;
    auto chain =
        measure_chain(drawing.baked, source->environment, options.truth.probes(), progress);
    if (!chain) return chain.error();
    results.chain = std::move(*chain);
    if (!results.truth) return results;
    const Status measured =
        measure_spheres(drawing, source->environment, pictures, results, progress);
    if (!measured) return measured.error();
    return results;
}

Status write_page_file(const Drawing& drawing, const PreviewOptions& options,
                       const Pictures& pictures, const PreviewResults& results) {
    if (results.page.empty()) return ok;
    Page page = page_of(drawing.baked, results);
    page.scene = drawing.scene;
    page.scene_note = options.scene.note();
    page.viewpoint = drawing.viewpoint;
    page.background = options.scene.background();
    page.exposure_stops = drawing.shown.exposure_stops;
    page.view = options.view.name;
    page.more_view = is_builtin(page.view) ? nullptr : &drawing.shown.view;
    if (pictures.truth) {
        page.truth->picture = &pictures.truth_image;
        page.truth->least_luminance = least_luminance(*pictures.truth);
    }
    return write_page(page, results.page);
}

Status check_files(const PreviewOptions& options) {
    if (const Status possible = check_picture_file(options.output.path()); !possible)
        return possible;
    return options.page.file.empty() ? ok : check_writable(options.page.file);
}

}  // namespace

Result<ExitCode> run_preview(const PreviewOptions& options, Progress& progress) {
    const auto file = options.output.path();
    if (const Status possible = check_files(options); !possible) return possible.error();
    const auto drawing = prepare(options);
    if (!drawing) return drawing.error();
    const auto source = read_source(options, drawing->baked, progress);
    if (!source) return source.error();
    const auto pictures = draw(*drawing, options, *source, progress);
    if (!pictures) return pictures.error();
    if (const Status written = write_pictures(*pictures, drawing->shown, file); !written)
        return written.error();
    if (pictures->truth && pictures->truth->end == TruthEnd::cancelled)
        return interrupted(*pictures, file);
    const auto results = measure(*drawing, options, *source, *pictures, progress);
    if (!results) return results.error();
    if (const Status written = write_page_file(*drawing, options, *pictures, *results); !written)
        return written.error();
    print(*results, options.json.json);
    return ExitCode::done;
}

}  // namespace splitsum::tools
