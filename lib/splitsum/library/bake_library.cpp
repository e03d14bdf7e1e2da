#include "splitsum/library/bake_library.h"

#include "splitsum/base/parallel.h"
#include "splitsum/base/text.h"
#include "splitsum/library/library_work_detail.h"
#include "splitsum/library/stopwatch.h"

namespace splitsum {
Status validate(std::span<const LibraryJob> jobs, const LibraryTable& table) {
    std::vector<ListedPanorama> panoramas;
    for (const LibraryJob& job : jobs) panoramas.push_back(job.panorama);
    if (const Status distinct = check_names(panoramas); !distinct) return distinct;
    for (const LibraryJob& job : jobs)
        if (const Status valid = validate(job.plan); !valid) return valid;
    return validate(table);
}

Result<LibrarySummary> bake_library(std::span<const LibraryJob> jobs, const LibraryRun& run,
                                    LibraryObserver& observer, Progress& progress) {
    const Stopwatch stopwatch;
    if (const Status valid = validate(jobs, run.table); !valid) return valid.error();
    const auto shard = jobs_of(run.shard, jobs);
    if (!shard) return shard.error();
    LibraryWork work(jobs, run, *shard, observer, progress);
    work.look_at_all();
    if (!run.dry_run)
        if (const Status baked = work.bake_the_rest(); !baked) return baked.error();
    LibrarySummary summary = work.summary();
    summary.seconds = stopwatch.seconds();
    return summary;
}

Result<std::vector<size_t>> jobs_of(const Shard& shard, std::span<const LibraryJob> jobs) {
    if (shard.count < 1 || shard.index < 1 || shard.index > shard.count)
        return Error{ErrorKind::bad_argument, cat("there is no part ", shard.index, " of ",
                                                  shard.count, "; parts count from 1")};
    std::vector<int64_t> pixels(jobs.size());
    // One shard needs no balance, and so no headers.
    if (shard.count > 1)
        parallel_rows(int(jobs.size()), [&](int i) {
            const LibraryJob& job = jobs[size_t(i)];
            pixels[size_t(i)] = pixels_in(job.panorama.file, job.reading);
        });
    return items_of(shard, pixels);
}

}  // namespace splitsum
