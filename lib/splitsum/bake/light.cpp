#include "splitsum/bake/light.h"

#include <algorithm>

#include "splitsum/bake/facts.h"
#include "splitsum/filter/spectral.h"
#include "splitsum/sphere/area_filter_builder.h"
#include "splitsum/sphere/environment_builder.h"
#include "splitsum/verify/check_levels.h"

namespace splitsum {
namespace {

constexpr int most_rows_kept = 1024;

Result<Light> load_all(const std::filesystem::path& path, const PanoramaOptions& options,
                       const LightUse& use, Progress& progress) {
    const auto panorama = read_panorama(path, options, progress);
    if (!panorama) return panorama.error();
    return light_of(*panorama, use.tables);
}

// What is built from the rows of a panorama as they come.
struct Builders {
    SpectrumBuilder spectrum;
    std::vector<AreaFilterBuilder> mirrors;
    EnvironmentBuilder environment;
    ExactProbes exact;
    ReconstructionRows readings;

    Builders(int height, int bands, const LightUse& use, int probes)
        : spectrum(height, bands),
          environment(height, most_rows_kept / 4),
          exact(height, panorama_from_cube(use.levels.orientation), probed_cubemaps(use.levels),
                probes),
          readings(height, panorama_from_cube(use.levels.orientation), roughness_bands(),
                   use.levels.specular ? probes : 0) {
        for (const int face_size : mirror_sizes(use.levels))
            mirrors.emplace_back(use.tables->area_geometry(
                height, face_size, panorama_from_cube(use.levels.orientation)));
    }

    void add(int row_count, const float* rgb) {
        spectrum.add_rows(row_count, rgb, 3);
        for (AreaFilterBuilder& mirror : mirrors) mirror.add_rows(row_count, rgb, 3);
        environment.add_rows(row_count, rgb, 3);
        exact.add_rows(row_count, rgb, 3);
        readings.add_rows(row_count, rgb, 3);
    }
};

Result<Light> stream(const std::filesystem::path& path, const PanoramaOptions& options,
                     const LightUse& use, int height, int bands, int probes, Progress& progress) {
    std::optional<Builders> builders(std::in_place, height, bands, use, probes);
    const auto panorama = stream_panorama(
        path, options,
        [&](int, int row_count, std::span<const float> rgb) {
            builders->add(row_count, rgb.data());
        },
        [&] { builders.emplace(height, bands, use, probes); }, progress);
    if (!panorama) return panorama.error();
    Light light{std::move(builders->environment).finish(), use.tables};
    light.spectrum = builders->spectrum.finish();
    for (AreaFilterBuilder& mirror : builders->mirrors)
        light.mirrors.push_back(std::move(mirror).finish());
    light.exact = std::move(builders->exact).finish();
    light.readings = std::move(builders->readings).finish();
    light.source = source_facts(*panorama);
    light.reading = panorama->reading;
    light.width = 2 * height;
    light.height = height;
    light.notes = panorama->notes;
    return light;
}

// The bands to begin with if harmonics are all that the plan needs.
std::optional<int> bands_of(const LightUse& use) {
    const FilterPlan& filter = use.levels.filter;
    if (filter.method != "auto" && filter.method != "spectral") return std::nullopt;
    return bands_to_transform(*use.tables, lobes_of(use.levels), filter.accuracy);
}

}  // namespace

FilterSource Light::filter_source() const {
    FilterSource filtered(environment, tables);
    filtered.spectrum = spectrum ? &*spectrum : nullptr;
    filtered.mirrors = mirrors;
    return filtered;
}

Result<Light> load_light(const std::filesystem::path& path, const PanoramaOptions& options,
                         const LightUse& use, Progress& progress) {
    if (const Status valid = validate(use.levels); !valid) return valid.error();
    const auto size = panorama_size(path, options);
    if (!size) return size.error();
    const auto guess = bands_of(use);
    if (use.keep_texels || size->height <= most_rows_kept || !guess)
        return load_all(path, options, use, progress);
    const int probes = use.probes.value_or(default_probes(size->height));
    auto light = stream(path, options, use, size->height, *guess, probes, progress);
    if (!light) return light.error();
    const int bands = bands_needed(*use.tables, *light->spectrum, lobes_of(use.levels),
                                   use.levels.filter.accuracy);
    if (bands <= *guess) return light;
    auto again = stream(path, options, use, size->height, bands, 0, progress);
    if (again) {
        again->exact = std::move(light->exact);
        again->readings = std::move(light->readings);
    }
    return again;
}

std::vector<ProbedCubemap> probed_cubemaps(const LevelsPlan& plan) {
    std::vector<ProbedCubemap> cubemaps;
    if (plan.specular)
        cubemaps =
            probed_chain(plan.specular->face_size,
                         roughness_of_levels(plan.specular->roughness, plan.specular->levels));
    if (plan.irradiance)
        for (const int face_size : {plan.irradiance->face_size, harmonics_face_size})
            cubemaps.push_back({{LobeKind::cosine}, face_size});
    return cubemaps;
}

Result<std::vector<ExactTexels>> exact_texels(const Light& light, const LevelsPlan& plan,
                                              std::optional<int> probes, Progress& progress) {
    if (!light.exact.empty()) return light.exact;
    return exact_texels(light.environment, panorama_from_cube(plan.orientation),
                        probed_cubemaps(plan), probes.value_or(default_probes(light.height)),
                        progress);
}

Result<ReconstructionProbes> exact_readings(const Light& light, const LevelsPlan& plan,
                                            std::optional<int> probes, Progress& progress) {
    if (light.readings) return *light.readings;
    return reconstruction_probes(light.environment, panorama_from_cube(plan.orientation),
                                 roughness_bands(), probes.value_or(default_probes(light.height)),
                                 progress);
}

Light light_of(const Panorama& panorama, std::shared_ptr<FilterTables> tables) {
    Light light{Environment(panorama.pixels), std::move(tables)};
    light.source = source_facts(panorama);
    light.reading = panorama.reading;
    light.width = panorama.pixels.width;
    light.height = panorama.pixels.height;
    light.notes = panorama.notes;
    return light;
}

}  // namespace splitsum
