#include "splitsum/bake/recipe.h"

#include <charconv>

#include "splitsum/base/content_hash.h"
#include "splitsum/base/text.h"
#include "splitsum/base/version.h"

namespace splitsum {
namespace {

// Every struct is taken apart by structured bindings: a field that is added to one of them does not
// compile here until it is part of the recipe.

// The fewest digits that read back to the same number.
std::string text_of(double value) {
    char digits[32];
    return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

std::string text_of(bool value) { return value ? "yes" : "no"; }

void add_reading(const PanoramaOptions& reading, const std::string& config, Settings& settings) {
    const auto& [color_space, ocio_config, layer, exposure_stops, repair] = reading;
    settings.insert(settings.end(), {{"colorspace", color_space},
                                     {"ocio-config", ocio_config.empty() ? "built-in" : config},
                                     {"layer", layer},
                                     {"exposure", text_of(exposure_stops)},
                                     {"repair", text_of(repair)}});
}

void add_specular(const SpecularPlan& plan, Settings& settings) {
    const auto& [face_size, levels, curve] = plan;
    settings.insert(
        settings.end(),
        {{"size", cat(face_size)}, {"levels", cat(levels)}, {"roughness", to_string(curve)}});
}

void add_irradiance(const IrradiancePlan& plan, Settings& settings) {
    const auto& [face_size, harmonics_order, windowed, store_irradiance] = plan;
    settings.insert(settings.end(), {{"irradiance-size", cat(face_size)},
                                     {"irradiance-order", cat(harmonics_order)},
                                     {"irradiance-window", text_of(windowed)},
                                     {"irradiance-store-e", text_of(store_irradiance)}});
}

void add_filter(const FilterPlan& plan, Settings& settings) {
    const auto& [method, samples, accuracy, rotate_samples, seed, sequence, heuristic] = plan;
    settings.insert(settings.end(),
                    {{"method", method},
                     {"samples", cat(samples)},
                     {"accuracy", text_of(accuracy)},
                     {"rotate-samples", text_of(rotate_samples)},
                     {"seed", cat(seed)},
                     {"sequence", std::string(name_of(point_sequences(), sequence))},
                     {"heuristic", std::string(name_of(mis_heuristics(), heuristic))}});
}

void add_orientation(const Orientation& orientation, Settings& settings) {
    const auto& [rotate_degrees, mirror, convention] = orientation;
    settings.insert(settings.end(), {{"rotate", text_of(rotate_degrees)},
                                     {"mirror", text_of(mirror)},
                                     {"convention", convention}});
}

void add_container(const ContainerOptions& options, Settings& settings) {
    const auto& [ktx2] = options;
    const auto& [zstd, zstd_level] = ktx2;
    settings.insert(settings.end(), {{"zstd", text_of(zstd)}, {"zstd-level", cat(zstd_level)}});
}

void add_plan(const BakePlan& plan, Settings& settings) {
    const auto& [specular, irradiance, filter, orientation, format, container, probes, picture] =
        plan;
    add_specular(specular, settings);
    add_irradiance(irradiance, settings);
    add_filter(filter, settings);
    add_orientation(orientation, settings);
    settings.emplace_back("format", info_of(format).name);
    add_container(container, settings);
    settings.emplace_back("probes", probes ? cat(*probes) : "default");
    settings.emplace_back("picture", text_of(picture));
}

}  // namespace

Result<Settings> settings_of(const PanoramaOptions& reading, const BakePlan& plan,
                             ConfigHashes& configs) {
    const auto config = configs.of(reading.ocio_config);
    if (!config) return config.error();
    Settings settings;
    add_reading(reading, *config, settings);
    add_plan(plan, settings);
    return settings;
}

std::string recipe_of(const std::string& source_name, const std::string& source_hash,
                      const Settings& settings) {
    ContentHash hash;
    // A NUL behind each, so that no two lists run into the same text.
    const auto add = [&](std::string_view text) {
        hash.add(text);
        hash.add(std::string_view("", 1));
    };
    add("splitsum bake");
    add(cat(algorithm_version));
    add(source_name);
    add(source_hash);
    for (const auto& [name, value] : settings) {
        add(name);
        add(value);
    }
    return named_hash(hash.digits());
}

Result<std::string> recipe_of(const std::string& source_name, const std::string& source_hash,
                              const PanoramaOptions& reading, const BakePlan& plan,
                              ConfigHashes& configs) {
    const auto settings = settings_of(reading, plan, configs);
    if (!settings) return settings.error();
    return recipe_of(source_name, source_hash, *settings);
}

}  // namespace splitsum
