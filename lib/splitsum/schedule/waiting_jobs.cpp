#include <algorithm>
#include <limits>

#include "splitsum/schedule/waiting_jobs_detail.h"

namespace splitsum {

WaitingJobs::WaitingJobs(const std::vector<Job>& jobs, const Budget& budget)
    : threads_(budget.threads), free_(budget.bytes.value_or(std::numeric_limits<int64_t>::max())) {
    for (size_t i = 0; i < jobs.size(); ++i) waiting_.insert({jobs[i].bytes, i});
}

std::optional<WaitingJobs::Started> WaitingJobs::start() {
    if (waiting_.empty()) return std::nullopt;
    const Place place = choose();
    if (place == waiting_.end()) return std::nullopt;
    const Place largest = waiting_.begin();
    if (place == largest)
        overtaken_ = 0;
    else if (largest->bytes > free_ - kept_for_smallest())
        ++overtaken_;
    const Started started{place->job, place->bytes, place->bytes == smallest()->bytes};
    waiting_.erase(place);
    free_ -= started.bytes;
    ++running_;
    if (started.is_smallest) ++running_smallest_;
    return started;
}

void WaitingJobs::end(const Started& started) {
    free_ += started.bytes;
    --running_;
    if (started.is_smallest) --running_smallest_;
}

WaitingJobs::Place WaitingJobs::choose() const {
    const Place largest = waiting_.begin();
    const bool waited_long = overtaken_ >= 4 * threads_;
    if (waited_long) return largest->bytes <= free_ ? largest : waiting_.end();
    const bool last_thread = threads_ > 1 && running_ + 1 == threads_;
    if (!last_thread || running_smallest_ > 0)
        if (const Place place = largest_within(free_ - kept_for_smallest());
            place != waiting_.end())
            return place;
    return smallest()->bytes <= free_ ? smallest() : waiting_.end();
}

// The first of those that need least.
WaitingJobs::Place WaitingJobs::smallest() const {
    return waiting_.lower_bound({waiting_.rbegin()->bytes, 0});
}

WaitingJobs::Place WaitingJobs::largest_within(int64_t bytes) const {
    return waiting_.lower_bound({bytes, 0});
}

int64_t WaitingJobs::kept_for_smallest() const {
    return threads_ > 1 && running_smallest_ == 0 ? smallest()->bytes : 0;
}

}  // namespace splitsum
