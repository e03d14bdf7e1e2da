#include "splitsum/schedule/schedule.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <numeric>
#include <thread>

#include "splitsum/base/parallel.h"

namespace splitsum {
namespace {

using std::chrono::milliseconds;

class Cancellation final : public Progress {
public:
    void begin(std::string_view, int) override {}
    void advance(int) override {}
    bool cancelled() const override { return cancelled_; }
    void cancel() { cancelled_ = true; }

private:
    std::atomic<bool> cancelled_ = false;
};

/// What goes on while jobs run, and the most there ever was of it.
class Watch {
public:
    void begin(size_t job, int64_t bytes) {
        const std::lock_guard lock(mutex_);
        order.push_back(job);
        most_jobs = std::max(most_jobs, ++jobs_);
        most_bytes = std::max(most_bytes, bytes_ += bytes);
    }
    void end(int64_t bytes) {
        const std::lock_guard lock(mutex_);
        --jobs_, bytes_ -= bytes;
    }

    std::vector<size_t> order;  ///< in which jobs were started
    int most_jobs = 0;
    int64_t most_bytes = 0;

private:
    std::mutex mutex_;
    int jobs_ = 0;
    int64_t bytes_ = 0;
};

/// Jobs of those sizes that take a moment each.
std::vector<Job> watched_jobs(const std::vector<int64_t>& sizes, Watch& watch) {
    std::vector<Job> jobs;
    for (size_t i = 0; i < sizes.size(); ++i)
        jobs.push_back({sizes[i], [&watch, i, bytes = sizes[i]] {
                            watch.begin(i, bytes);
                            std::this_thread::sleep_for(milliseconds(1));
                            watch.end(bytes);
                        }});
    return jobs;
}

std::vector<size_t> sorted(std::vector<size_t> order) {
    std::ranges::sort(order);
    return order;
}

std::vector<size_t> first_numbers(size_t count) {
    std::vector<size_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), size_t{0});
    return numbers;
}

// Sizes in no order, some of them far above the others.
std::vector<int64_t> lopsided_sizes() {
    std::vector<int64_t> sizes;
    for (int i = 0; i < 60; ++i) sizes.push_back(i % 7 == 3 ? 90 + i % 11 : 5 + i * 37 % 23);
    return sizes;
}

class RunJobs : public testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(Threads, RunJobs, testing::Values(1, 2, 3, 8, 100));

TEST_P(RunJobs, RunsEachOnceWithinThreadsAndBytes) {
    for (const auto bytes : {std::optional<int64_t>(100), std::optional<int64_t>(130),
                             std::optional<int64_t>(400), std::optional<int64_t>()}) {
        Watch watch;
        ASSERT_TRUE(
            run_jobs(watched_jobs(lopsided_sizes(), watch), {GetParam(), bytes}, NoProgress()));
        EXPECT_EQ(sorted(watch.order), first_numbers(60));
        EXPECT_LE(watch.most_jobs, GetParam());
        EXPECT_LE(watch.most_bytes, bytes.value_or(watch.most_bytes));
    }
}

TEST_P(RunJobs, TakesManyTrivialJobs) {
    std::atomic<int> count = 0;
    std::vector<Job> jobs(10'000, Job{0, [&] { ++count; }});
    ASSERT_TRUE(run_jobs(std::move(jobs), {GetParam(), 0}, NoProgress()));
    EXPECT_EQ(count, 10'000);
}

TEST_P(RunJobs, TakesNone) { EXPECT_TRUE(run_jobs({}, {GetParam(), 0}, NoProgress())); }

TEST_P(RunJobs, StartsNoMoreWhenCancelled) {
    Cancellation cancellation;
    std::atomic<int> begun = 0, ended = 0;
    const auto run = [&] {
        if (++begun == 5) cancellation.cancel();
        ++ended;
    };
    const Status status =
        run_jobs(std::vector<Job>(1000, Job{1, run}), {GetParam(), {}}, cancellation);
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().kind, ErrorKind::interrupted);
    EXPECT_GE(begun, 5);
    EXPECT_LT(begun, 5 + GetParam());  // those that had started
    EXPECT_EQ(begun, ended);
}

// Cancelled within the last one: nothing was left undone.
TEST_P(RunJobs, SucceedsWhenEveryJobWasRun) {
    Cancellation cancellation;
    EXPECT_TRUE(run_jobs({Job{1, [&] { cancellation.cancel(); }}}, {GetParam(), {}}, cancellation));
}

TEST_P(RunJobs, RunsNothingWhenCancelledBefore) {
    Cancellation cancellation;
    cancellation.cancel();
    int begun = 0;
    EXPECT_FALSE(run_jobs({Job{1, [&] { ++begun; }}}, {GetParam(), {}}, cancellation));
    EXPECT_EQ(begun, 0);
}

TEST(RunJobsWithOneThread, StartsLargeJobsFirstAndEqualsInOrder) {
    Watch watch;
    ASSERT_TRUE(run_jobs(watched_jobs({3, 9, 3, 1, 9, 7}, watch), {1, {}}, NoProgress()));
    EXPECT_EQ(watch.order, (std::vector<size_t>{1, 4, 5, 0, 2, 3}));
}

TEST(RunJobsThatCannot, AreRefusedBeforeAnyRuns) {
    Watch watch;
    const Status too_large = run_jobs(watched_jobs({1, 12, 3}, watch), {2, 11}, NoProgress());
    ASSERT_FALSE(too_large);
    EXPECT_EQ(too_large.error().kind, ErrorKind::bad_argument);
    EXPECT_NE(too_large.error().message.find("12"), std::string::npos);
    EXPECT_FALSE(run_jobs(watched_jobs({1}, watch), {0, {}}, NoProgress()));
    EXPECT_TRUE(watch.order.empty());
}

// With as many jobs as threads their loops get no help, and a job that is alone gets all of it.
TEST(ThreadsOfJobs, AreSharedByThoseThatRun) {
    const int threads = 3;
    std::atomic<int> begun = 0;
    std::vector<int> together(threads), alone(1);
    std::vector<Job> jobs;
    for (int i = 0; i < threads; ++i)
        jobs.push_back({1, [&, i] {
                            ++begun;
                            while (begun < threads) std::this_thread::yield();
                            together[size_t(i)] = ThreadLimit::in_force();
                            ++begun;
                            while (begun < 2 * threads) std::this_thread::yield();
                        }});
    const ThreadLimit outer(threads);
    ASSERT_TRUE(run_jobs(std::move(jobs), {threads, {}}, NoProgress()));
    EXPECT_EQ(together, std::vector(threads, 1));
    ASSERT_TRUE(run_jobs({Job{1, [&] { alone[0] = ThreadLimit::in_force(); }}}, {threads, {}},
                         NoProgress()));
    EXPECT_EQ(alone[0], ThreadLimit::in_force());  // also what holds when all have ended
}

}  // namespace
}  // namespace splitsum
