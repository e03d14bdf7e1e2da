#include "splitsum/schedule/schedule.h"

#include <algorithm>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <system_error>
#include <thread>

#include "splitsum/base/parallel.h"
#include "splitsum/base/text.h"
#include "splitsum/schedule/waiting_jobs_detail.h"

namespace splitsum {
namespace {

class Runner {
public:
    Runner(std::vector<Job> jobs, const Budget& budget, const Progress& cancellation)
        : jobs_(std::move(jobs)),
          threads_(budget.threads),
          cancellation_(cancellation),
          waiting_(jobs_, budget) {}

    /// Runs jobs until none is left to start; on as many threads at a time as may run jobs.
    void work() {
        std::unique_lock lock(mutex_);
        while (const auto started = next(lock)) {
            share_threads();
            lock.unlock();
            jobs_[started->job].run();
            jobs_[started->job].run = nullptr;  // with all that it holds
            lock.lock();
            waiting_.end(*started);
            changed_.notify_all();
        }
        share_threads();
    }

    bool all_were_run() const { return waiting_.empty(); }

private:
    std::optional<WaitingJobs::Started> next(std::unique_lock<std::mutex>& lock) {
        while (!waiting_.empty() && !cancellation_.cancelled()) {
            if (const auto started = waiting_.start()) return started;
            share_threads();
            changed_.wait(lock);
        }
        return std::nullopt;
    }

    // Each running job has its own thread; what is left of the budget helps in their loops. Idle
    // threads would steal rows otherwise, and the jobs would wait for cores instead of working.
    void share_threads() {
        const int allowed = threads_ - std::max(1, waiting_.running()) + 1;
        if (limit_ && allowed == allowed_) return;
        allowed_ = allowed;
        // The new limit is in force before the old one ends.
        auto limit = std::make_unique<ThreadLimit>(allowed);
        limit_ = std::move(limit);
    }

    std::vector<Job> jobs_;
    const int threads_;
    const Progress& cancellation_;

    std::mutex mutex_;  // of all below
    std::condition_variable changed_;
    WaitingJobs waiting_;
    std::unique_ptr<ThreadLimit> limit_;
    int allowed_ = 0;
};

Status validate(const std::vector<Job>& jobs, const Budget& budget) {
    if (budget.threads < 1)
        return Error{ErrorKind::bad_argument,
                     cat("cannot run jobs on ", budget.threads, " threads; at least 1 is needed")};
    for (const Job& job : jobs)
        if (job.bytes > budget.bytes.value_or(job.bytes))
            return Error{ErrorKind::bad_argument,
                         cat("a job needs ", job.bytes, " bytes, more than the limit of ",
                             *budget.bytes, " for all jobs together")};
    return ok;
}

}  // namespace

Status run_jobs(std::vector<Job> jobs, const Budget& budget, const Progress& cancellation) {
    if (const Status valid = validate(jobs, budget); !valid) return valid;
    if (jobs.empty()) return ok;
    const size_t others = std::min(jobs.size(), static_cast<size_t>(budget.threads)) - 1;
    Runner runner(std::move(jobs), budget, cancellation);
    {
        std::vector<std::jthread> threads;
        try {
            while (threads.size() < others) threads.emplace_back([&] { runner.work(); });
        } catch (const std::system_error&) {
            // As many threads as the system allows do the same work.
        }
        runner.work();
    }
    if (runner.all_were_run()) return ok;
    return Error{ErrorKind::interrupted, "interrupted before everything was begun"};
}

}  // namespace splitsum
