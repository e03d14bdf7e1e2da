#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"

namespace splitsum {

/// Work that does not depend on other jobs, such as the bake of one panorama.
struct Job {
    /// Memory at its peak, beyond what the process holds before: an upper bound, at least 0.
    int64_t bytes = 0;
    /// Must not throw. May use parallel loops; looks at Progress::cancelled itself.
    std::function<void()> run;
};

/// What the jobs share.
struct Budget {
    int threads = 1;               ///< at least 1: jobs and the threads of their loops together
    std::optional<int64_t> bytes;  ///< of all running jobs together; no limit if not given
};

/// Runs every job once, many at a time, and returns when all of them have ended.
///
/// A job runs on one thread, and its parallel loops on that and on whatever threads the jobs leave
/// free: none while there are as many jobs as threads, more and more towards the end. Jobs never
/// run inside one another, so none has to wait for another's end in the middle of a loop.
///
/// Jobs that need much memory start first, so that none of them is left over at the end; equals
/// start in the order of the list. One thread is kept for the jobs that need least, and room for
/// one of these in memory. Where the next large job does not fit, smaller ones overtake it, but so
/// few that it starts before long: then everything waits until there is room for it.
///
/// Once `cancellation` is cancelled no more jobs start.
///
/// Fails with bad_argument, before any job runs, if there is no thread or a job needs more than
/// budget.bytes: the caller has better words for that, and drops such jobs. Fails with interrupted
/// if a job was not run.
Status run_jobs(std::vector<Job> jobs, const Budget& budget, const Progress& cancellation);

}  // namespace splitsum
