#pragma once

#include <atomic>
#include <filesystem>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "splitsum/library/bake_library.h"
#include "splitsum/library/bake_panorama.h"
#include "splitsum/library/run_progress_detail.h"
#include "splitsum/schedule/schedule.h"

namespace splitsum {

/// A run of bake_library on its way: the items of its shard, step by step.
class LibraryWork {
public:
    LibraryWork(std::span<const LibraryJob> jobs, const LibraryRun& run,
                const std::vector<size_t>& shard, LibraryObserver& observer, Progress& progress);

    /// Finds out what is up to date, and why the rest is not.
    void look_at_all();

    /// Bakes the rest. Fails as run_jobs does.
    Status bake_the_rest();

    /// Everything but the time.
    LibrarySummary summary() const;

private:
    const LibraryJob& job_of(const LibraryItem& item) const { return jobs_[item.job]; }
    std::filesystem::path folder_of(const LibraryItem& item) const;
    void look_at(LibraryItem& item);
    std::vector<Job> schedule(const std::vector<LibraryItem*>& stale);
    std::optional<int64_t> memory_of_jobs() const;
    Status check_memory(const LibraryItem& item, int64_t bytes) const;
    void bake(LibraryItem& item);
    Status bake_guarded(LibraryItem& item);
    void settle(LibraryItem& item, const Status& status);
    void need_table();
    void finished(const LibraryItem& item);

    std::span<const LibraryJob> jobs_;
    const LibraryRun& run_;
    LibraryObserver& observer_;
    RunProgress progress_;
    BakeShop shop_;
    std::vector<LibraryItem> items_;
    std::mutex observing_;  // one call of the observer at a time
    std::atomic<bool> table_claimed_ = false;
    std::optional<TableResult> table_;  // written by who has claimed it
};

}  // namespace splitsum
