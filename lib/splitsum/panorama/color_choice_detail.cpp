#include "splitsum/panorama/color_choice_detail.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "splitsum/base/text.h"

namespace splitsum {
namespace {

/// OpenImageIO calls EXR and HDR files linear without knowing their primaries.
bool says_only_linear(const std::string& name) {
    return name.empty() || name == "linear" || name == "Linear";
}

Result<ColorChoice> named_choice(const ColorConfig& config, const std::string& name) {
    auto converter = config.converter_from(name);
    if (!converter) return converter.error();
    return ColorChoice{std::move(*converter), *config.find(name), {}};
}

/// Nothing where the primaries span no colours.
Result<std::optional<ColorChoice>> choice_by_primaries(const Primaries& primaries) {
    if (const auto name = space_with_primaries(primaries)) {
        const auto builtin = ColorConfig::load({});
        if (!builtin) return builtin.error();
        auto choice = named_choice(*builtin, *name);
        if (!choice) return choice.error();
        return std::optional(std::move(*choice));
    }
    auto converter = ColorConfig::converter_from_primaries(primaries);
    if (!converter) return std::optional<ColorChoice>();
    return std::optional(ColorChoice{
        std::move(*converter), cat("linear with chromaticities ", join(primaries, " ")), {}});
}

/// What the file says in words: a space of the config, or else of the built-in one.
Result<ColorChoice> choice_by_name(const ColorConfig& config, const std::string& name) {
    if (config.find(name)) return named_choice(config, name);
    const auto builtin = ColorConfig::load({});
    if (!builtin) return builtin.error();
    if (builtin->find(name)) return named_choice(*builtin, name);
    auto choice = named_choice(config, config.default_space());
    if (choice)
        choice->notes.push_back(cat("the file says colour space '", name,
                                    "', which is not in the config; it was taken to be in ",
                                    choice->name));
    return choice;
}

Result<ColorChoice> choose(const ImageFileInfo& file, const PanoramaOptions& options,
                           const ColorConfig& config) {
    if (!options.color_space.empty()) return named_choice(config, options.color_space);
    std::vector<std::string> notes;
    if (file.chromaticities) {
        Primaries primaries{};
        std::ranges::copy(*file.chromaticities, primaries.begin());
        auto choice = choice_by_primaries(primaries);
        if (!choice) return choice.error();
        if (*choice) return std::move(**choice);
        notes.push_back(
            cat("ignored chromaticities that span no colours: ", join(*file.chromaticities, " ")));
    }
    auto choice = says_only_linear(file.color_space) ? named_choice(config, config.default_space())
                                                     : choice_by_name(config, file.color_space);
    if (!choice) return choice.error();
    if (file.color_space.empty() && !file.floating_point)
        notes.push_back(
            cat("the file holds integers and does not say its colour space; it was "
                "taken to be in ",
                choice->name));
    choice->notes.insert(choice->notes.end(), notes.begin(), notes.end());
    return choice;
}

}  // namespace

Result<ColorChoice> choose_color_space(const ImageFileInfo& file, const PanoramaOptions& options) {
    const auto config = ColorConfig::load(options.ocio_config);
    if (!config) return config.error();
    auto choice = choose(file, options, *config);
    if (choice && !config->note().empty()) choice->notes.push_back(config->note());
    return choice;
}

}  // namespace splitsum
