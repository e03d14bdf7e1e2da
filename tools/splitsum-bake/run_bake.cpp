#include "run_bake.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>

#include "common/run_tool.h"
#include "depfile.h"
#include "event_log.h"
#include "job_list.h"
#include "library_progress.h"
#include "library_results.h"
#include "observer_list.h"
#include "process_memory.h"
#include "run_merge.h"
#include "splitsum/base/atomic_file.h"
#include "splitsum/base/parallel.h"
#include "splitsum/base/text.h"

namespace splitsum::tools {
namespace {

namespace fs = std::filesystem;

LibraryRun library_run(const BakeOptions& options, const ContentCache* cache) {
    LibraryRun run;
    run.folder = options.output.path();
    run.table = {options.table.plan(), options.asset.encoding.container()};
    run.threads = ThreadLimit::in_force();
    if (options.effort.memory) run.memory = *options.effort.memory - resident_bytes();
    run.force = options.effort.force;
    run.dry_run = options.effort.dry_run;
    run.cache = cache;
    run.shard = options.source.shard;
    return run;
}

Result<std::optional<ContentCache>> open_cache(const EffortOptions& options) {
    if (options.cache.empty() || options.dry_run) return std::optional<ContentCache>();
    auto cache = ContentCache::open(options.cache, options.cache_bytes);
    if (!cache) return cache.error();
    return std::optional(std::move(*cache));
}

Status write_depfile(const TellingOptions& options, const JobList& list, const LibraryRun& run,
                     const LibrarySummary& summary) {
    std::vector<std::string> targets, sources;
    for (const LibraryItem& item : summary.items) {
        const ListedPanorama& panorama = list.jobs[item.job].panorama;
        targets.push_back((run.folder / panorama.name / "report.json").string());
        sources.push_back(panorama.file.string());
    }
    if (!options.depfile_target.empty()) targets = {options.depfile_target};
    for (const fs::path& source : list.sources) sources.push_back(source.string());
    const auto text = depfile_text(targets, sources);
    if (!text) return text.error();
    return write_text_whole(options.depfile, *text);
}

std::string progress_so_far(const LibrarySummary& summary) {
    const auto done = std::ranges::count_if(summary.items, [](const LibraryItem& item) {
        return item.outcome != Outcome::not_begun && item.outcome != Outcome::failed;
    });
    return cat(done, " of ", summary.items.size(),
               " panoramas are done; the same command goes on from there");
}

// What the run comes to: done, or the error that decides the exit code.
Status verdict(const LibrarySummary& summary) {
    const bool many = summary.items.size() > 1;
    if (const auto& stopped = summary.stopped) {
        if (stopped->kind == ErrorKind::interrupted)
            return Error{stopped->kind, cat("interrupted: ", progress_so_far(summary))};
        if (!many) return *stopped;
        return Error{stopped->kind, cat(stopped->message, "; stopped: ", progress_so_far(summary))};
    }
    const auto failed = [](const LibraryItem& item) { return item.error.has_value(); };
    const auto first = std::ranges::find_if(summary.items, failed);
    if (first == summary.items.end()) return ok;
    if (!many) return *first->error;
    return Error{first->error->kind,
                 cat(std::ranges::count_if(summary.items, failed), " of ", summary.items.size(),
                     " panoramas failed, the others are baked")};
}

// Of several panoramas each failure has a line of its own, before the line that counts them.
void print_failures(const CLI::App& app, const LibrarySummary& summary) {
    if (summary.items.size() < 2) return;
    for (const LibraryItem& item : summary.items)
        if (item.error)
            std::cerr << cat(app.get_name(), ": failed: ", one_line(item.error->message), "\n");
    std::cerr << std::flush;
}

ExitCode code_of(const Status& verdict) {
    return verdict ? ExitCode::done : exit_code_of(verdict.error().kind);
}

ProgressStyle style_of(const CLI::App& app, const TellingOptions& telling) {
    return progress_style(app.get_option("--quiet")->count() > 0 || telling.events == "-");
}

Result<ExitCode> run_library(const CLI::App& app, const BakeOptions& options, const JobList& list,
                             Progress& terminal) {
    const TellingOptions& telling = options.telling;
    const auto cache = open_cache(options.effort);
    if (!cache) return cache.error();
    const LibraryRun run = library_run(options, *cache ? &**cache : nullptr);

    LibraryProgress progress(style_of(app, telling), list.jobs, terminal);
    LibraryResults results({telling.json, run.dry_run}, list.jobs, run.folder,
                           [&](const std::string& text) { progress.print(text); });
    ObserverList observers({&progress, &results});
    std::unique_ptr<EventLog> events;
    if (!telling.events.empty() && !run.dry_run) {
        auto opened = EventLog::open(telling.events, list.jobs, run);
        if (!opened) return opened.error();
        events = std::move(*opened);
        observers.add(*events);
    }

    const auto summary = bake_library(list.jobs, run, observers, progress);
    if (!summary) return summary.error();
    progress.close();
    results.end(*summary);
    print_failures(app, *summary);
    Status status = verdict(*summary);
    if (status && !telling.depfile.empty() && !run.dry_run)
        status = write_depfile(telling, list, run, *summary);
    if (events)
        if (const Status told = events->end(*summary, int(code_of(status))); status && !told)
            status = told;
    if (!status) return status.error();
    return ExitCode::done;
}

}  // namespace

Result<ExitCode> run_bake(CLI::App& app, const BakeOptions& options,
                          std::span<const std::string> command, Progress& terminal) {
    if (const Status fit = check_together(options); !fit) return fit.error();
    const auto list = list_jobs(app, options);
    if (!list) return list.error();
    // A manifest may have set it after the program began.
    const ThreadLimit limit(app.get_option("--threads")->as<int>());
    if (options.effort.merge) return run_merge(command, options, *list, terminal);
    return run_library(app, options, *list, terminal);
}

}  // namespace splitsum::tools
