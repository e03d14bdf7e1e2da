#include <gtest/gtest.h>

#include <algorithm>
#include <deque>

#include "splitsum/schedule/waiting_jobs_detail.h"

namespace splitsum {
namespace {

std::vector<Job> jobs_of(const std::vector<int64_t>& sizes) {
    std::vector<Job> jobs;
    for (const int64_t bytes : sizes) jobs.push_back({bytes, [] {}});
    return jobs;
}

/// The sizes of `count` jobs of `bytes` each, then more of them.
std::vector<int64_t> mixed(size_t large_count, int64_t large, size_t small_count, int64_t small) {
    std::vector<int64_t> sizes(large_count, large);
    sizes.insert(sizes.end(), small_count, small);
    return sizes;
}

using Started = WaitingJobs::Started;

/// Starts what may start on `threads` threads.
void fill(WaitingJobs& waiting, int threads, std::deque<Started>& running) {
    while (int(running.size()) < threads) {
        const auto started = waiting.start();
        if (!started) return;
        running.push_back(*started);
    }
}

TEST(WaitingJobs, KeepOneThreadForTheSmallest) {
    const std::vector<int64_t> sizes = mixed(8, 100, 50, 3);
    WaitingJobs waiting(jobs_of(sizes), {4, {}});
    std::deque<Started> running;
    fill(waiting, 4, running);
    std::vector<int64_t> bytes;
    for (const Started& started : running) bytes.push_back(started.bytes);
    EXPECT_EQ(bytes, (std::vector<int64_t>{100, 100, 100, 3}));
    // When a small one ends, the next small one follows; when a large one ends, a large one.
    waiting.end(running.back());
    running.pop_back();
    fill(waiting, 4, running);
    EXPECT_EQ(running.back().bytes, 3);
    waiting.end(running.front());
    running.pop_front();
    fill(waiting, 4, running);
    EXPECT_EQ(running.back().bytes, 100);
}

TEST(WaitingJobs, KeepRoomForTheSmallest) {
    // Two large ones would fit, but then nothing else could run beside them.
    WaitingJobs waiting(jobs_of(mixed(4, 50, 20, 5)), {4, 100});
    std::deque<Started> running;
    fill(waiting, 4, running);
    EXPECT_EQ(std::ranges::count(running, 50, &Started::bytes), 1);
    EXPECT_EQ(std::ranges::count(running, 5, &Started::bytes), 3);
}

TEST(WaitingJobs, OvertakeALargeOneButNotForever) {
    // The large one needs everything, so small ones must stop for it.
    const int threads = 4;
    WaitingJobs waiting(jobs_of(mixed(1, 100, 1000, 5)), {threads, 100});
    std::deque<Started> running;
    int before = 0;
    for (fill(waiting, threads, running); running.front().bytes != 100; ++before) {
        ASSERT_LT(before, 8 * threads);
        waiting.end(running.front());
        running.pop_front();
        fill(waiting, threads, running);
        ASSERT_FALSE(running.empty());
    }
    EXPECT_EQ(running.size(), 1U);
    EXPECT_GE(before, threads);  // some did overtake
}

// The one that has run longest ends next: every job gets its turn, whatever the sizes and limits,
// and memory is never exceeded.
TEST(WaitingJobs, AllGetTheirTurn) {
    uint32_t state = 1;
    const auto number_below = [&](uint32_t end) {
        state = state * 1664525U + 1013904223U;
        return (state >> 8) % end;
    };
    for (int round = 0; round < 300; ++round) {
        const int threads = 1 + int(number_below(6));
        const int64_t limit = 1 + number_below(200);
        std::vector<int64_t> sizes;
        for (uint32_t i = 0; i < 80; ++i) sizes.push_back(number_below(uint32_t(limit) + 1));
        WaitingJobs waiting(jobs_of(sizes), {threads, limit});
        std::deque<Started> running;
        std::vector<int> runs(sizes.size(), 0);
        while (!waiting.empty() || !running.empty()) {
            fill(waiting, threads, running);
            ASSERT_FALSE(running.empty()) << "nothing runs, and something waits";
            int64_t bytes = 0;
            for (const Started& started : running) bytes += started.bytes;
            ASSERT_LE(bytes, limit);
            const auto ends = running.begin() + ptrdiff_t(number_below(uint32_t(running.size())));
            ++runs[ends->job];
            waiting.end(*ends);
            running.erase(ends);
        }
        EXPECT_EQ(runs, std::vector<int>(sizes.size(), 1));
    }
}

}  // namespace
}  // namespace splitsum
