// Limits, the order in which entries go, and what killed processes leave.
#include <fcntl.h>
#include <sys/file.h>

#include <chrono>
#include <limits>
#include <thread>

#include "unit/cache/entries.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;
using namespace tests;

using EvictionTest = CacheTest;

// So that the order of use is clear where clocks are coarse.
void used_long_ago(const fs::path& entry, int seconds) {
    fs::last_write_time(entry / "index",
                        fs::file_time_type::clock::now() - std::chrono::seconds(seconds));
}

TEST_F(EvictionTest, TheLeastRecentlyUsedGoFirst) {
    const ContentCache cache = open(4500);
    for (const int n : {3, 1, 4, 2}) ASSERT_TRUE(store(cache, n));
    used_long_ago(entry_of(3), 10);
    used_long_ago(entry_of(1), 40);
    used_long_ago(entry_of(4), 30);
    used_long_ago(entry_of(2), 20);
    EXPECT_TRUE(fetches(cache, 1));  // used now
    ASSERT_TRUE(store(cache, 4));    // there already: used now
    ASSERT_TRUE(store(cache, 5));
    EXPECT_EQ(kept(9), (std::vector{1, 3, 4, 5}));
    used_long_ago(entry_of(5), 50);
    ASSERT_TRUE(store(cache, 6));
    EXPECT_EQ(kept(9), (std::vector{1, 3, 4, 6}));
    EXPECT_EQ(parts(), 0u);
}

TEST_F(EvictionTest, TheLimitHoldsAfterEveryStore) {
    const ContentCache cache = open(10'000);
    for (int n = 0; n < 60; ++n) {
        const size_t bytes = 100 + size_t(n) * 997 % 3000;
        ASSERT_TRUE(store(cache, n, bytes));
        size_t sum = 0;
        for (const int k : kept(n)) sum += 100 + size_t(k) * 997 % 3000;
        EXPECT_LE(sum, 10'000u);
        EXPECT_GE(sum, n > 20 ? 6'000u : 0u);  // and not much more than needed is removed
        EXPECT_TRUE(fetches(cache, n, bytes)) << n;
    }
}

TEST_F(EvictionTest, ASmallerLimitTakesEffectWithTheNextStore) {
    for (int n = 0; n < 9; ++n) ASSERT_TRUE(store(open(), n));
    for (int n = 0; n < 9; ++n) used_long_ago(entry_of(n), 100 - n);
    ASSERT_TRUE(store(open(2200), 9));
    EXPECT_EQ(kept(9), (std::vector{8, 9}));
}

TEST_F(EvictionTest, WhatIsLargerThanTheLimitIsNotKept) {
    const ContentCache cache = open(1500);
    ASSERT_TRUE(store(cache, 1));
    EXPECT_TRUE(store(cache, 2, 1501));
    EXPECT_EQ(kept(2), (std::vector{1}));
    EXPECT_TRUE(store(cache, 2, 1500));
    EXPECT_EQ(kept(2), (std::vector{2}));
}

TEST_F(EvictionTest, ALimitOfNothingGivesUntilTheFirstStore) {
    ASSERT_TRUE(store(open(), 1));
    const ContentCache cache = open(0);
    EXPECT_TRUE(fetches(cache, 1));
    EXPECT_TRUE(store(cache, 2));
    EXPECT_TRUE(kept(2).empty());
}

TEST_F(EvictionTest, AnAbsurdLimitIsNoLimit) {
    const ContentCache cache = open(std::numeric_limits<int64_t>::max());
    for (int n = 0; n < 20; ++n) ASSERT_TRUE(store(cache, n));
    EXPECT_EQ(kept(30).size(), 20u);
}

TEST_F(EvictionTest, EntriesOfOtherProcessesAreNoticed) {
    const ContentCache cache = open(16'000);
    ASSERT_TRUE(store(cache, 0));
    EXPECT_EQ(in_a_process([&] {
                  const ContentCache other = open(16'000);
                  for (int n = 1; n < 16; ++n)
                      if (!store(other, n)) return 1;
                  return 0;
              }),
              0);
    // It has stored two entries by its own count, and more than a sixteenth of the limit.
    for (int n = 16; n < 18; ++n) ASSERT_TRUE(store(cache, n));
    EXPECT_LE(kept(20).size(), 16u);
}

TEST_F(EvictionTest, SeveralThreadsMayStoreAndFetch) {
    const ContentCache cache = open(5500);
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([&, t] {
            for (int i = 0; i < 40; ++i) {
                const int n = (i * (t + 1)) % 9;
                EXPECT_TRUE(store(cache, n));
                (void)fetches(cache, n);
            }
        });
    for (std::thread& thread : threads) thread.join();
    ASSERT_TRUE(store(open(5500), 20));
    EXPECT_LE(kept(20).size(), 5u);
    EXPECT_EQ(parts(), 0u);
}

// ---- leftovers

class LeftoverTest : public CacheTest {
protected:
    static std::string boot() {
        std::string digits = bytes_of("/proc/sys/kernel/random/boot_id");
        std::erase_if(digits, [](char letter) { return letter == '-' || letter == '\n'; });
        return digits;
    }
    fs::path part(const std::string& of_boot, int hours) {
        const fs::path folder = cache_folder() / "parts" / (of_boot + "-0123456789abcdef");
        write_files(folder, {{"0", "half"}, {"index", ""}});
        fs::last_write_time(folder, fs::file_time_type::clock::now() - std::chrono::hours(hours));
        return folder;
    }
};

TEST_F(LeftoverTest, OfThisMachineGoAtOnceUnlessTheirProcessLives) {
    (void)open();
    const fs::path folder = part(boot(), 0);
    const int alive = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    ASSERT_EQ(flock(alive, LOCK_EX | LOCK_NB), 0);
    fs::last_write_time(folder, fs::file_time_type::clock::now() - std::chrono::hours(99));
    ASSERT_TRUE(store(open(), 1));
    EXPECT_TRUE(fs::exists(folder / "0"));
    close(alive);
    ASSERT_TRUE(store(open(), 2));
    EXPECT_EQ(parts(), 0u);
}

TEST_F(LeftoverTest, OfOtherMachinesGoAfterADay) {
    (void)open();
    const std::string elsewhere(32, 'e');
    part(elsewhere, 23);
    ASSERT_TRUE(store(open(), 1));
    EXPECT_EQ(parts(), 1u);
    part(elsewhere, 25);
    ASSERT_TRUE(store(open(), 2));
    EXPECT_EQ(parts(), 0u);
}

}  // namespace
}  // namespace splitsum
