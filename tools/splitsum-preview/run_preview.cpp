#include "run_preview.h"

#include "light/asset_source.h"
#include "light/cubemap_tool.h"
#include "picture_file.h"
#include "results.h"
#include "splitsum/picture/exposure.h"

namespace splitsum::tools {
namespace {

/// What is drawn, and how it is shown.
struct Drawing {
    Scene scene;
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
        options.view.exposure_stops().value_or(exposure_stops_of(baked->light.specular.front()));
    const Camera camera = camera_for(*scene, options.scene.viewpoint());
    return Drawing{std::move(*scene), camera, std::move(*baked),
                   Shown{std::move(*view), exposure_stops}};
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

}  // namespace

Result<ExitCode> run_preview(const PreviewOptions& options, Progress& progress) {
    const auto file = options.output.path();
    if (const Status possible = check_picture_file(file); !possible) return possible.error();
    const auto drawing = prepare(options);
    if (!drawing) return drawing.error();

    PreviewResults results;
    results.file = file;
    results.view = options.view.name;
    results.exposure_stops = drawing->shown.exposure_stops;
    results.notes = drawing->baked.notes;
    results.spheres = spheres_in(*drawing);
    if (!options.panorama.empty()) {
        const auto source =
            read_asset_source(options.panorama, drawing->baked.facts, options.reading, progress);
        if (!source) return source.error();
        results.notes.insert(results.notes.end(), source->notes.begin(), source->notes.end());
        const Environment environment(source->panorama.pixels);
        auto chain = measure_chain(drawing->baked, environment, options.probes, progress);
        if (!chain) return chain.error();
        results.chain = std::move(*chain);
    }
    auto picture = baked_picture(drawing->scene, drawing->camera, drawing->baked.light,
                                 options.scene.background(), progress);
    if (!picture) return picture.error();
    std::vector<NamedPicture> pictures;
    pictures.push_back({"baked", std::move(*picture)});
    if (const Status written = write_pictures(pictures, drawing->shown, file); !written)
        return written.error();
    for (const NamedPicture& named : pictures) results.pictures.push_back(named.name);
    print(results, options.json.json);
    return ExitCode::done;
}

}  // namespace splitsum::tools
