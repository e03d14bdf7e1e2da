#include "splitsum/base/parallel.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <numeric>
#include <stdexcept>
#include <thread>

namespace splitsum {
namespace {

using std::chrono::milliseconds;

/// Makes 0, 1, 2, ... into three items and takes them, with the number of threads as parameter.
class MakeAndTake : public testing::TestWithParam<int> {
protected:
    template <class Take>
    void run(int count, const Take& take) {
        const auto make = [&](int& item) {
            if (made_ == count) return false;
            item = made_++;
            return true;
        };
        make_and_take(std::span<int>(items_), make, take);
    }

    ThreadLimit limit_{GetParam()};
    std::array<int, 3> items_{};
    std::atomic<int> made_ = 0;
};

INSTANTIATE_TEST_SUITE_P(Threads, MakeAndTake, testing::Values(1, 2, 4));

// Slow takes let making run ahead: an item that is used again too early comes out wrong.
TEST_P(MakeAndTake, TakesEveryItemInOrder) {
    std::vector<int> taken;
    run(200, [&](int item) {
        if (item % 40 == 0) std::this_thread::sleep_for(milliseconds(2));
        EXPECT_LE(made_ - int(taken.size()), int(items_.size()));
        taken.push_back(item);
        return true;
    });
    std::vector<int> all(200);
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(taken, all);
}

TEST_P(MakeAndTake, EndsWhenThereIsNothingToMake) {
    run(0, [](int) -> bool { throw std::logic_error("there is nothing to take"); });
    EXPECT_EQ(made_, 0);
}

// Also where the next ones have been made already.
TEST_P(MakeAndTake, EndsWhenNoMoreIsWanted) {
    std::vector<int> taken;
    run(1000, [&](int item) {
        taken.push_back(item);
        std::this_thread::sleep_for(milliseconds(2));
        return item < 5;
    });
    EXPECT_EQ(taken, (std::vector<int>{0, 1, 2, 3, 4, 5}));
    EXPECT_LE(made_, 5 + 1 + int(items_.size()));
}

TEST_P(MakeAndTake, HandsOnWhatIsThrown) {
    EXPECT_THROW(run(50,
                     [](int item) -> bool {
                         if (item == 7) throw std::runtime_error("seven");
                         return true;
                     }),
                 std::runtime_error);
    const auto make = [](int&) -> bool { throw std::runtime_error("nothing"); };
    EXPECT_THROW(make_and_take(std::span<int>(items_), make, [](int) { return true; }),
                 std::runtime_error);
}

// Loops within are parallel as ever, and a thread that waits in one does not begin the other kind
// of work, which would hold up its own.
TEST_P(MakeAndTake, LoopsInsideDoNotMixTheTwo) {
    static thread_local bool taking = false;
    std::atomic<int> mixed = 0, rows_done = 0;
    int made = 0;
    const auto make = [&](int&) {
        mixed += taking;
        parallel_rows(8, [&](int) { std::this_thread::sleep_for(milliseconds(1)); });
        return made++ < 20;
    };
    make_and_take(std::span<int>(items_), make, [&](int) {
        taking = true;
        parallel_rows(8, [&](int) {
            std::this_thread::sleep_for(milliseconds(1));
            ++rows_done;
        });
        taking = false;
        return true;
    });
    EXPECT_EQ(rows_done, 20 * 8);
    EXPECT_EQ(mixed, 0);
}

TEST(MakeAndTakeTogether, MakesTheNextWhileOneIsTaken) {
    if (ThreadLimit::available() < 2) GTEST_SKIP() << "one core";
    std::array<int, 3> items{};
    std::atomic<int> made = 0;
    bool next_was_made = false;
    make_and_take(
        std::span<int>(items), [&](int&) { return ++made <= 2; },
        [&](int) {
            for (int wait = 0; made < 2 && wait < 5000; ++wait)
                std::this_thread::sleep_for(milliseconds(1));
            next_was_made = made >= 2;
            return false;
        });
    EXPECT_TRUE(next_was_made);
}

TEST(RunBoth, RunsBothToTheirEnds) {
    for (const int threads : {1, 4}) {
        const ThreadLimit limit(threads);
        int first = 0;
        std::vector<int> second(100);
        run_both([&] { first = 1; },
                 [&] { parallel_rows(100, [&](int i) { second[size_t(i)] = i; }); });
        EXPECT_EQ(first, 1);
        EXPECT_EQ(std::accumulate(second.begin(), second.end(), 0), 4950);
        EXPECT_THROW(run_both([] {}, [] { throw std::runtime_error("second"); }),
                     std::runtime_error);
    }
}

}  // namespace
}  // namespace splitsum
