#include <algorithm>
#include <exception>
#include <new>

#include "splitsum/base/parallel.h"
#include "splitsum/base/staged_folder.h"
#include "splitsum/base/temporary.h"
#include "splitsum/base/text.h"
#include "splitsum/library/freshness.h"
#include "splitsum/library/library_work_detail.h"
#include "splitsum/library/memory_of_bake.h"
#include "splitsum/library/stopwatch.h"

namespace splitsum {
namespace {

constexpr int64_t mebibyte = 1 << 20;

int64_t mebibytes(int64_t bytes) { return (bytes + mebibyte - 1) / mebibyte; }

int64_t pixels_of(const PanoramaSize& size) { return int64_t(size.width) * size.height; }

}  // namespace

LibraryWork::LibraryWork(std::span<const LibraryJob> jobs, const LibraryRun& run,
                         const std::vector<size_t>& shard, LibraryObserver& observer,
                         Progress& progress)
    : jobs_(jobs), run_(run), observer_(observer), progress_(progress), shop_{run.cache} {
    items_.resize(shard.size());
    for (size_t i = 0; i < shard.size(); ++i) items_[i].job = shard[i];
    observer_.begun(shard);
}

std::filesystem::path LibraryWork::folder_of(const LibraryItem& item) const {
    return run_.folder / job_of(item).panorama.name;
}

void LibraryWork::look_at_all() {
    // Of whoever was killed over the table, which may be up to date since.
    if (!run_.dry_run) remove_leftovers(run_.folder);
    parallel_rows(int(items_.size()), [&](int i) {
        if (!progress_.cancelled()) look_at(items_[size_t(i)]);
    });
    const auto uses_table = [&](const LibraryItem& item) {
        return item.outcome == Outcome::up_to_date ||
               (run_.dry_run && item.outcome == Outcome::not_begun);
    };
    if (!progress_.cancelled() && std::ranges::any_of(items_, uses_table)) need_table();
}

void LibraryWork::look_at(LibraryItem& item) {
    const Stopwatch stopwatch;
    const LibraryJob& job = job_of(item);
    if (!run_.dry_run) remove_leftovers(folder_of(item));
    auto found =
        check_freshness(job.panorama.file, job.reading, job.plan, folder_of(item), shop_.configs);
    item.seconds = stopwatch.seconds();
    if (!found) return settle(item, found.error());
    item.why = found->why;
    if (!found->up_to_date) return;
    if (found->source && found->source->was_read && !run_.dry_run)
        (void)remember_source(folder_of(item), found->source->stamp, found->source->hash);
    if (found->baked) item.facts = facts_from(*found->baked);
    if (run_.force) {
        item.why = "it is up to date, and baked again by force";
        return;
    }
    item.outcome = Outcome::up_to_date;
    settle(item, ok);
}

Status LibraryWork::bake_the_rest() {
    std::vector<LibraryItem*> stale;
    for (LibraryItem& item : items_)
        if (item.outcome == Outcome::not_begun) stale.push_back(&item);
    if (progress_.cancelled()) return ok;
    if (stale.empty()) {
        observer_.planned({}, {});
        return ok;
    }
    // Asked before the work; what was made for the question goes again.
    if (const auto possible = StagedFolder::create(run_.folder); !possible) {
        progress_.stop(possible.error());
        return ok;
    }
    if (stale.size() == 1) progress_.show_stages();
    const Status ran = run_jobs(schedule(stale), {run_.threads, memory_of_jobs()}, progress_);
    // What was interrupted is told by its items.
    return !ran && ran.error().kind != ErrorKind::interrupted ? ran : ok;
}

// A job for each item that can be baked. The others fail here, before the long work.
std::vector<Job> LibraryWork::schedule(const std::vector<LibraryItem*>& stale) {
    std::vector<int64_t> pixels(stale.size()), bytes(stale.size());
    parallel_rows(int(stale.size()), [&](int row) {
        const size_t i = size_t(row);
        if (progress_.cancelled()) return;
        const LibraryJob& job = job_of(*stale[i]);
        const auto size = panorama_size(job.panorama.file, job.reading);
        if (!size) return settle(*stale[i], size.error());
        pixels[i] = splitsum::pixels_of(*size);
        bytes[i] = memory_of_bake(*size, job.plan, run_.threads);
        if (const Status fits = check_memory(*stale[i], bytes[i]); !fits) settle(*stale[i], fits);
    });
    std::vector<Job> work;
    std::vector<size_t> planned;
    std::vector<int64_t> planned_pixels;
    for (size_t i = 0; i < stale.size(); ++i) {
        if (stale[i]->outcome == Outcome::failed) continue;
        work.push_back({bytes[i], [this, item = stale[i]] { bake(*item); }});
        planned.push_back(stale[i]->job);
        planned_pixels.push_back(pixels[i]);
    }
    observer_.planned(planned, planned_pixels);
    return work;
}

// What the limit leaves beside what all bakes share.
std::optional<int64_t> LibraryWork::memory_of_jobs() const {
    if (!run_.memory) return std::nullopt;
    return std::max<int64_t>(*run_.memory - memory_of_shared_tables, 0);
}

Status LibraryWork::check_memory(const LibraryItem& item, int64_t bytes) const {
    const auto limit = memory_of_jobs();
    if (!limit || bytes <= *limit) return ok;
    return Error{
        ErrorKind::bad_argument,
        cat("baking ", job_of(item).panorama.file.string(), " may take ", mebibytes(bytes),
            "M of memory with ", run_.threads, " threads, and the limit leaves ", *limit / mebibyte,
            "M; a limit that is ", mebibytes(bytes - *limit), "M higher would do",
            job_of(item).reading.repair
                ? "; less does without --repair, which may have to keep all pixels"
                : "")};
}

void LibraryWork::bake(LibraryItem& item) {
    if (progress_.cancelled()) return;
    {
        const std::lock_guard lock(observing_);
        observer_.started(item.job);
    }
    const Stopwatch stopwatch;
    item.facts.reset();
    const Status status = bake_guarded(item);
    item.seconds = stopwatch.seconds();
    settle(item, status);
    if (status) need_table();
}

// Third parties throw; a panorama's exception is its own failure.
Status LibraryWork::bake_guarded(LibraryItem& item) {
    const std::string file = job_of(item).panorama.file.string();
    try {
        return bake_panorama(job_of(item), folder_of(item), shop_, item, progress_);
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::internal,
                     cat(file, ": out of memory; smaller outputs or fewer threads need less")};
    } catch (const std::exception& failure) {
        return Error{ErrorKind::internal, cat(file, ": a fault of the program: ", failure.what())};
    }
}

// The end of work on an item. Outputs that cannot be written stop the run: the next one could not
// be either.
void LibraryWork::settle(LibraryItem& item, const Status& status) {
    if (!status && status.error().kind == ErrorKind::interrupted) {
        item.outcome = Outcome::not_begun;
    } else if (!status) {
        item.outcome = Outcome::failed;
        item.error = status.error();
        if (status.error().kind == ErrorKind::unwritable_output) progress_.stop(status.error());
    }
    finished(item);
}

void LibraryWork::need_table() {
    if (table_claimed_.exchange(true)) return;
    table_ = find_library_table(run_.table, run_.folder);
    if (table_->outcome == Outcome::up_to_date && !run_.force) return;
    if (run_.dry_run) return;
    const std::string why = table_->why;
    auto baked = bake_library_table(run_.table, run_.folder, progress_);
    if (!baked) {
        table_->outcome = Outcome::failed;
        return progress_.stop(baked.error());
    }
    table_ = std::move(*baked);
    table_->why = why;
}

void LibraryWork::finished(const LibraryItem& item) {
    const std::lock_guard lock(observing_);
    observer_.finished(item);
}

LibrarySummary LibraryWork::summary() const {
    LibrarySummary summary;
    summary.items = items_;
    summary.table = table_;
    summary.stopped = progress_.reason();
    const bool all_settled =
        std::ranges::none_of(items_, [](const auto& i) { return i.outcome == Outcome::not_begun; });
    if (!summary.stopped && progress_.cancelled() && !all_settled)
        summary.stopped = Error{ErrorKind::interrupted, "interrupted"};
    return summary;
}

}  // namespace splitsum
