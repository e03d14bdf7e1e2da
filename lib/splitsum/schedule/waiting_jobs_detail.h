#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "splitsum/schedule/schedule.h"

namespace splitsum {

/// Which job runs next: the order that schedule.h describes, without threads.
class WaitingJobs {
public:
    /// No job needs more than budget.bytes.
    WaitingJobs(const std::vector<Job>& jobs, const Budget& budget);

    bool empty() const { return waiting_.empty(); }

    /// A job taken from the list.
    struct Started {
        size_t job;
        int64_t bytes;
        bool is_smallest;  ///< the one kept going among larger ones
    };

    /// The job to start now, for which there must be a thread; none where memory has to come free.
    /// Never none while nothing runs and a job waits.
    std::optional<Started> start();

    /// What start() gave has ended.
    void end(const Started& started);

    int running() const { return running_; }

private:
    // Largest first, then in the order of the list.
    struct Waiting {
        int64_t bytes;
        size_t job;
        bool operator<(const Waiting& other) const {
            return bytes != other.bytes ? bytes > other.bytes : job < other.job;
        }
    };
    using Place = std::set<Waiting>::const_iterator;

    Place smallest() const;
    Place largest_within(int64_t bytes) const;
    Place choose() const;
    int64_t kept_for_smallest() const;

    int threads_;
    int64_t free_;
    std::set<Waiting> waiting_;
    int running_ = 0;
    int running_smallest_ = 0;
    int overtaken_ = 0;  // jobs that started since the largest one could have
};

}  // namespace splitsum
