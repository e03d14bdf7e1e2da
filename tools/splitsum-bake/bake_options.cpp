#include "bake_options.h"

#include <utility>

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
           "2:1 lat-long images (.exr, .hdr, .tif, .pfm, ...), and folders, which are searched "
           "for them")
        ->option_text("...")
        ->check(not_empty());
    app.add_option("--include", include,
                   "of folders, only files that match such a pattern: '*.exr', 'dusk/*'; again for "
                   "another")
        ->option_text("PATTERN")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->check(not_empty());
    app.add_option("--exclude", exclude, "of folders, no files that match such a pattern")
        ->option_text("PATTERN")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->check(not_empty());
    app.add_option(
           "--manifest", manifest,
           "a .toml or .json file that names panoramas and options of their own, in place of "
           "PANORAMA")
        ->option_text("FILE")
        ->check(not_empty());
    app.add_option_function<std::string>(
           "--shard", [this](const std::string& text) { shard = *parse_shard(text); },
           "only a part of them: 2/8 is the second of eight with about equal pixels (default 1/1)")
        ->option_text("I/N")
        ->check(shard_text());
    under_heading(app, "Which panoramas");
}

EffortOptions::EffortOptions(CLI::App& app) {
    app.add_flag("--force", force, "bake again what is up to date");
    app.add_flag("--dry-run", dry_run,
                 "say what would be baked, and why; nothing is written, --depfile and --events "
                 "included");
    app.add_flag(
        "--merge", merge,
        "bake nothing, and check that DIR is complete, up to date, and what its certificates "
        "say;\nexit code 1 if not");
    app.add_option("--memory", memory,
                   "what the process may hold, 256M or more: as many panoramas at once as fit "
                   "(default: no limit)")
        ->option_text(byte_count_name)
        ->transform(byte_count(int64_t{256} << 20, int64_t{1} << 50));
    app.add_option(
           "--cache", cache,
           "a folder of results that libraries, processes and machines share, made if it is "
           "missing")
        ->option_text("FOLDER")
        ->check(not_empty());
    app.add_option(
           "--cache-size", cache_bytes,
           cat("what the cache may hold; what was not used for longest goes first (default ",
               byte_count_text(cache_bytes), ")"))
        ->option_text(byte_count_name)
        ->transform(byte_count(0, int64_t{1} << 50));
    under_heading(app, "What is done");
}

TellingOptions::TellingOptions(CLI::App& app) {
    app.add_flag("--json", json, "print the results as JSON");
    app.add_option(
           "--events", events,
           "append what happens to FILE, a JSON object a line; '-': stderr, without progress")
        ->option_text("FILE")
        ->check(not_empty());
    auto* file =
        app.add_option("--depfile", depfile,
                       "write to FILE, for Make and Ninja, which files the results depend on")
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

Status check_together(const BakeOptions& options) {
    const EffortOptions& effort = options.effort;
    if (!effort.merge) return ok;
    const std::pair<bool, const char*> others[] = {{effort.force, "--force"},
                                                   {effort.dry_run, "--dry-run"},
                                                   {!effort.cache.empty(), "--cache"},
                                                   {options.source.shard.count > 1, "--shard"},
                                                   {!options.telling.depfile.empty(), "--depfile"},
                                                   {!options.telling.events.empty(), "--events"}};
    for (const auto& [given, name] : others)
        if (given)
            return Error{
                ErrorKind::bad_argument,
                cat("--merge checks the whole library and bakes nothing; leave out ", name)};
    return ok;
}

}  // namespace splitsum::tools
