#include "bake_options.h"

#include "splitsum/base/text.h"

namespace splitsum::tools {
namespace {

// Options that were registered since the last call stand under this heading in --help.
void under_heading(CLI::App& app, const std::string& heading) {
    for (CLI::Option* option : app.get_options())
        if (option->get_group() == "Options" && option != app.get_help_ptr())
            option->group(heading);
}

CLI::Validator shard_text() {
    return {[](std::string& text) {
                const auto shard = parse_shard(text);
                return shard ? std::string() : shard.error().message;
            },
            ""};
}

}  // namespace

SourceOptions::SourceOptions(CLI::App& app) {
    app.add_option(
           "PANORAMA", inputs,
           "2:1 lat-long images (.exr, .hdr, .tif, .pfm, ...) and folders of them, searched "
           "with all that is in them")
        ->option_text("...")
        ->check(not_empty());
    app.add_option(
           "--include", include,
           "of folders, only files that match such a pattern, as a shell has them: '*.exr', "
           "'dusk/*'; may be given more than once")
        ->option_text("PATTERN")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->check(not_empty());
    app.add_option("--exclude", exclude, "of folders, no files that match such a pattern")
        ->option_text("PATTERN")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->check(not_empty());
    app.add_option("--manifest", manifest,
                   "a .toml or .json file that names the panoramas and their options, in the place "
                   "of PANORAMA")
        ->option_text("FILE")
        ->check(not_empty());
    app.add_option_function<std::string>(
           "--shard", [this](const std::string& text) { shard = *parse_shard(text); },
           "only this part of the panoramas, such as 2/8: the second of eight that differ little "
           "in "
           "their pixels (default 1/1)")
        ->option_text("I/N")
        ->check(shard_text());
    under_heading(app, "Which panoramas");
}

EffortOptions::EffortOptions(CLI::App& app) {
    app.add_flag("--force", force, "bake again what is up to date");
    auto* dry = app.add_flag("--dry-run", dry_run,
                             "say what would be baked, and why; nothing is written, neither in DIR "
                             "nor by --depfile and --events");
    auto* merging =
        app.add_flag("--merge", merge,
                     "bake nothing, but check that DIR is complete: each panorama up to "
                     "date, each certificate true; exit code 1 if not");
    app.add_option(
           "--cache", cache,
           "a folder of results that other libraries, processes and machines share; made if "
           "it is missing")
        ->option_text("FOLDER")
        ->check(not_empty());
    merging->excludes(dry)->excludes("--force")->excludes("--cache")->excludes("--shard");
    under_heading(app, "What is done");
}

TellingOptions::TellingOptions(CLI::App& app) {
    app.add_flag("--json", json, "print the results as JSON");
    app.add_option("--events", events,
                   "append what happens to FILE, a JSON object a line; '-' is the standard error, "
                   "without progress then")
        ->option_text("FILE")
        ->check(not_empty());
    auto* file = app.add_option("--depfile", depfile,
                                "write the files that the results depend on to FILE, for Make and "
                                "Ninja")
                     ->option_text("FILE")
                     ->check(not_empty());
    app.add_option("--depfile-target", depfile_target,
                   "what depends on them, as the build calls it (default: each report.json)")
        ->option_text("NAME")
        ->check(not_empty())
        ->needs(file);
    under_heading(app, "What is told");
}

BakeOptions::BakeOptions(CLI::App& app)
    : source(app),
      output(app, "DIR", "the folder of the results, made if it is missing"),
      effort(app),
      telling(app),
      asset(app),
      table((under_heading(app, "What is made of a panorama"), app), "table-") {
    under_heading(app, "The table");
    // A manifest may name it as well.
    app.get_option("--output")->required(false);
}

}  // namespace splitsum::tools
