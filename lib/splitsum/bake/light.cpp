#include "splitsum/bake/light.h"

#include <algorithm>

#include "splitsum/bake/facts.h"
#include "splitsum/filter/spectral.h"
#include "splitsum/sphere/environment_builder.h"

namespace splitsum {
namespace {

constexpr int most_rows_kept = 1024;

Result<Light> load_all(const std::filesystem::path& path, const PanoramaOptions& options,
                       Progress& progress) {
    const auto panorama = read_panorama(path, options, progress);
    if (!panorama) return panorama.error();
    return Light{Environment(panorama->pixels), std::nullopt, source_facts(*panorama),
                 panorama->notes};
}

// A few rows for each row of the mirror level, and enough to look at.
int averaged_rows(int height, const LevelsPlan& plan) {
    const int wanted = std::max(most_rows_kept, plan.specular ? 6 * plan.specular->face_size : 0);
    const int shrink = (height + wanted - 1) / wanted;
    return (height + shrink - 1) / shrink;
}

// What is built from the rows of a panorama as they come.
struct Builders {
    SpectrumBuilder spectrum;
    EnvironmentBuilder environment;

    Builders(int height, int bands, const LevelsPlan& plan)
        : spectrum(height, bands), environment(height, averaged_rows(height, plan)) {}

    void add(int row_count, const float* rgb) {
        spectrum.add_rows(row_count, rgb, 3);
        environment.add_rows(row_count, rgb, 3);
    }
};

Result<Light> stream(const std::filesystem::path& path, const PanoramaOptions& options,
                     const LevelsPlan& plan, int height, int bands, Progress& progress) {
    Builders builders(height, bands, plan);
    const auto panorama = stream_panorama(
        path, options,
        [&](int, int row_count, std::span<const float> rgb) {
            builders.add(row_count, rgb.data());
        },
        [&] { builders = Builders(height, bands, plan); }, progress);
    if (!panorama) return panorama.error();
    return Light{std::move(builders.environment).finish(), builders.spectrum.finish(),
                 source_facts(*panorama), panorama->notes};
}

// The bands to transform if harmonics are all that the plan needs.
std::optional<int> bands_of(const LevelsPlan& plan) {
    if (plan.filter.method != "auto" && plan.filter.method != "spectral") return std::nullopt;
    return bands_to_transform(lobes_of(plan), plan.filter.accuracy);
}

}  // namespace

Result<Light> load_light(const std::filesystem::path& path, const PanoramaOptions& options,
                         const LevelsPlan& plan, bool keep_texels, Progress& progress) {
    const auto size = panorama_size(path, options);
    if (!size) return size.error();
    const auto bands = bands_of(plan);
    if (keep_texels || size->height <= most_rows_kept || !bands)
        return load_all(path, options, progress);
    auto light = stream(path, options, plan, size->height, *bands, progress);
    if (!light) return light.error();
    // A sun too strong for the guess: with all texels at hand, as many bands as it takes.
    if (!has_enough_bands(*light->spectrum, lobes_of(plan), plan.filter.accuracy))
        return load_all(path, options, progress);
    return light;
}

}  // namespace splitsum
