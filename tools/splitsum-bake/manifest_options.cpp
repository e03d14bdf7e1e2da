#include "manifest_options.h"

#include <algorithm>
#include <array>
#include <optional>
#include <unordered_map>

#include "plan_options.h"
#include "splitsum/base/text.h"

namespace splitsum::tools {
namespace {

// What to do, for whom, and what chooses among panoramas is said with each call.
constexpr std::array command_line_options = {
    "help",  "version", "quiet", "json",    "manifest", "include", "exclude",
    "shard", "force",   "merge", "dry-run", "events",   "depfile", "depfile-target",
};

// An app of the options that manifests may set for each panorama, and of no others.
struct PanoramaApp {
    PanoramaApp() { app.set_help_flag(); }

    bool has(const std::string& name) const { return app.get_option_no_throw("--" + name); }

    CLI::App app;
    PlanOptions options{app};
};

// The long name, of a flag with an opposite that which turns it on; "" for positional arguments.
std::string name_of(const CLI::Option& option) {
    const auto& opposites = option.get_fnames();
    for (const std::string& name : option.get_lnames())
        if (std::ranges::find(opposites, name) == opposites.end()) return name;
    return "";
}

OptionType type_of(const CLI::Option& option) {
    if (option.get_items_expected_max() == 0) return OptionType::flag;
    const std::string type = option.get_type_name();
    if (type == "INT" || type == "UINT" || type == "FLOAT") return OptionType::number;
    const std::string placeholder = option.get_option_text();
    if (placeholder == "FILE" || placeholder == "DIR" || placeholder == "FOLDER")
        return OptionType::path;
    if (placeholder == "CURVE") return OptionType::number_list;
    if (placeholder == "NAME") return OptionType::text;
    return OptionType::number_or_text;
}

OptionPlace place_of_option(const std::string& name, const PanoramaApp& panorama) {
    if (panorama.has(name)) return OptionPlace::panorama;
    const bool typed = std::ranges::find(command_line_options, name) != command_line_options.end();
    return typed ? OptionPlace::command_line : OptionPlace::run;
}

bool was_typed(const CLI::App& app, const CLI::Option* option) {
    // An option that took its value from the environment has one too, but was not parsed.
    return std::ranges::find(app.parse_order(), option) != app.parse_order().end();
}

// Without the name of the option that CLI11 puts in front.
std::string problem_of(const CLI::ParseError& error, const std::string& option) {
    const std::string message = error.what();
    const std::string name = "--" + option + ": ";
    return message.starts_with(name) ? message.substr(name.size()) : message;
}

// The options that manifests may set for each panorama and that were typed, as settings.
std::vector<Setting> typed_settings(const CLI::App& app) {
    const PanoramaApp panorama;
    std::vector<Setting> settings;
    for (const CLI::Option* option : app.get_options()) {
        const std::string name = name_of(*option);
        if (!was_typed(app, option) || !panorama.has(name)) continue;
        settings.push_back(
            {name, option->results().back(), type_of(*option) == OptionType::flag, {}, 0});
    }
    std::ranges::sort(settings, {}, &Setting::option);
    return settings;
}

// As if they had been typed. Throws CLI::ParseError.
void parse_settings(CLI::App& app, std::span<const Setting> settings) {
    std::vector<std::string> arguments;  // the last first, as CLI11 wants it
    for (const Setting& setting : settings)
        arguments.push_back(cat("--", setting.option, "=", setting.value));
    std::ranges::reverse(arguments);
    app.parse(std::move(arguments));
}

// Of settings that were refused together: the one that is wrong by itself, if any is.
std::optional<std::string> problem_of_one(std::span<const Setting> settings) {
    for (const Setting& setting : settings) {
        try {
            PanoramaApp alone;
            parse_settings(alone.app, {&setting, 1});
        } catch (const CLI::RequiresError&) {  // which the others may meet
        } catch (const CLI::ParseError& error) {
            return cat(place_of(setting), ": ", setting.option, ": ",
                       problem_of(error, setting.option));
        }
    }
    return std::nullopt;
}

Result<PanoramaPlan> plan_of(const ManifestPanorama& panorama, std::span<const Setting> settings) {
    const auto refused = [&](const std::string& problem) {
        return Error{ErrorKind::bad_argument, cat(place_of(panorama), ": ", problem)};
    };
    try {
        PanoramaApp parsed;
        parse_settings(parsed.app, settings);
        const auto plan = parsed.options.plan();
        if (!plan) return refused(plan.error().message);
        return PanoramaPlan{parsed.options.reading.plan(), *plan};
    } catch (const CLI::ParseError& error) {
        if (const auto problem = problem_of_one(settings))
            return Error{ErrorKind::bad_argument, *problem};
        return refused(error.what());
    }
}

std::string key_of(std::span<const Setting> settings) {
    std::string key;
    for (const Setting& setting : settings) key += setting.option + '=' + setting.value + '\n';
    return key;
}

}  // namespace

std::vector<KnownOption> options_of_manifests(const CLI::App& app) {
    const PanoramaApp panorama;
    std::vector<KnownOption> known;
    for (const CLI::Option* option : app.get_options()) {
        const std::string name = name_of(*option);
        if (!name.empty())
            known.push_back({name, type_of(*option), place_of_option(name, panorama)});
    }
    return known;
}

Result<std::vector<PanoramaPlan>> plans_of_manifest(std::span<const ManifestPanorama> panoramas,
                                                    const CLI::App& app) {
    constexpr size_t most_problems = 10;
    const std::vector<Setting> typed = typed_settings(app);
    std::unordered_map<std::string, PanoramaPlan> plan_of_settings;
    std::vector<std::string> problems;
    std::vector<PanoramaPlan> plans;
    for (const ManifestPanorama& panorama : panoramas) {
        const std::vector<Setting> settings = overlaid(typed, panorama.settings);
        const auto [known, is_new] = plan_of_settings.try_emplace(key_of(settings));
        if (is_new) {
            auto plan = plan_of(panorama, settings);
            if (plan)
                known->second = std::move(*plan);
            else if (std::ranges::find(problems, plan.error().message) == problems.end())
                problems.push_back(plan.error().message);
            if (problems.size() == most_problems) break;
        }
        plans.push_back(known->second);
    }
    if (problems.empty()) return plans;
    return Error{ErrorKind::bad_argument, join(problems, "\n")};
}

Status apply_run_settings(CLI::App& app, std::span<const Setting> settings) {
    for (const Setting& setting : settings) {
        CLI::Option* option = app.get_option_no_throw("--" + setting.option);
        if (!option || was_typed(app, option)) continue;
        try {
            option->clear();
            option->add_result(setting.value);
            option->run_callback();
        } catch (const CLI::ParseError& error) {
            return Error{ErrorKind::bad_argument, cat(place_of(setting), ": ", setting.option, ": ",
                                                      problem_of(error, setting.option))};
        }
    }
    return ok;
}

}  // namespace splitsum::tools
