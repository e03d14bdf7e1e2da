#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "splitsum/bake/bake.h"
#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/cache/content_cache.h"
#include "splitsum/library/baked_facts.h"
#include "splitsum/library/library_table.h"
#include "splitsum/library/outcome.h"
#include "splitsum/library/panorama_list.h"
#include "splitsum/library/shard.h"
#include "splitsum/panorama/panorama.h"

namespace splitsum {

/// One panorama of a library: where it is, how it is read, and what is made of it.
struct LibraryJob {
    ListedPanorama panorama;
    PanoramaOptions reading;
    BakePlan plan;
};

/// What holds for the whole run.
struct LibraryRun {
    std::filesystem::path folder;  ///< of the results, made if it is missing
    LibraryTable table;
    int threads = 1;  ///< at least 1: panoramas at once and the loops within them share these
    /// Bytes that the run may take beyond what the process holds before; no limit if not given.
    std::optional<int64_t> memory;
    bool force = false;                   ///< bake what is up to date too
    bool dry_run = false;                 ///< say what would be done, and write nothing
    const ContentCache* cache = nullptr;  ///< where results come from and go to, if anywhere
    Shard shard;                          ///< the part of the library to look after
};

/// What became of a panorama.
struct LibraryItem {
    size_t job = 0;
    Outcome outcome = Outcome::not_begun;
    std::string why;                  ///< why it was or has to be baked, half a sentence
    std::optional<Error> error;       ///< of a failed one
    std::optional<BakedFacts> facts;  ///< of what is in its folder, where that is complete
    std::vector<std::string> notes;   ///< what came up while it was baked, a sentence each
    double seconds = 0;
};

/// Told what goes on. Called by any thread, but never by two at a time; must not throw.
class LibraryObserver {
public:
    virtual ~LibraryObserver() = default;

    /// The run begins to look at the jobs with these numbers: those of its shard.
    virtual void begun(std::span<const size_t> /*jobs*/) {}
    /// All are looked at; `jobs` will be baked, or taken from the cache, and have so many pixels.
    virtual void planned(std::span<const size_t> /*jobs*/, std::span<const int64_t> /*pixels*/) {}
    /// Work on that job begins.
    virtual void started(size_t /*job*/) {}
    /// The job is settled: once for each but those that a stopped run did not come to.
    virtual void finished(const LibraryItem& /*item*/) {}
};

/// What became of all.
struct LibrarySummary {
    std::vector<LibraryItem> items;    ///< of the shard, in the order of the list
    std::optional<TableResult> table;  ///< once there is a panorama to use it with
    std::optional<Error> stopped;  ///< why nothing more was begun, if so; `interrupted` included
    double seconds = 0;
};

/// Brings a library up to date: looks at each panorama of the shard, and bakes those whose results
/// are missing or not what recipe and source ask for, many at a time, into folder/<name>. The table
/// follows after the first success, so that a run which can make nothing leaves nothing behind.
///
/// A panorama that fails fails alone. What stops the run is in the summary: the caller's wish, after
/// which panoramas in progress are dropped; an output that cannot be written, as the next one could
/// not either; a table that cannot be made. The same call goes on from where it ended.
///
/// What is written does not depend on the threads, shards or processes at work. Of several runs in
/// one folder each sees complete results only.
///
/// Progress: the stages of the bake where there is only one; else the observer tells.
/// Fails, before anything is written, with bad_argument: two panoramas of one name, a plan or table
/// that cannot work, a shard that is none.
Result<LibrarySummary> bake_library(std::span<const LibraryJob> jobs, const LibraryRun& run,
                                    LibraryObserver& observer, Progress& progress);

/// Whether the results of all jobs can lie in one folder, and every plan and the table can work.
/// Fails with bad_argument.
Status validate(std::span<const LibraryJob> jobs, const LibraryTable& table);

/// The jobs of a shard, in the order of the list. Fails with bad_argument for a shard that is none.
Result<std::vector<size_t>> jobs_of(const Shard& shard, std::span<const LibraryJob> jobs);

}  // namespace splitsum
