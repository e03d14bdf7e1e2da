// Several processes that store, fetch and evict, and are killed at it.

#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "unit/cache/entries.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;
using namespace tests;

constexpr int numbers = 24;
constexpr int64_t limit = 600'000;

size_t bytes_of_number(int n) { return 20'000 + size_t(n) * 7919 % 90'000; }

class ProcessesTest : public CacheTest {
protected:
    ProcessesTest() {
        for (int n = 0; n < numbers; ++n) write_files(baked(n), files_of(n, bytes_of_number(n)));
    }
    fs::path baked(int n) const { return temporary_ / cat("baked", n); }

    /// Fetches into a folder of the worker's: all right files or none.
    bool fetch_is_right(const ContentCache& cache, int n, const fs::path& into) const {
        fs::create_directories(into);
        const auto found = cache.fetch(key_of(n), into);
        const bool right = found && (*found ? files_in(into) == files_of(n, bytes_of_number(n))
                                            : fs::is_empty(into));
        fs::remove_all(into);
        return right;
    }

    /// Works until it is killed; ends with a code of what went wrong.
    int work(unsigned seed) const {
        std::mt19937 random(seed);
        const fs::path into = temporary_ / cat("into", getpid());
        while (true) {
            const ContentCache cache = open(limit);
            for (int i = 0; i < 20; ++i) {
                const int n = int(random() % numbers);
                if (random() % 2 == 0) {
                    if (!cache.store(key_of(n), baked(n))) return 2;
                } else if (!fetch_is_right(cache, n, into)) {
                    return 3;
                }
            }
        }
    }
};

TEST_F(ProcessesTest, KilledAtAnyMomentTheyLeaveAWholeCache) {
    constexpr int workers = 6, kills = 100;
    std::mt19937 random(1);
    std::vector<Process> processes;
    for (unsigned i = 0; i < workers; ++i) processes.emplace_back([this, i] { return work(i); });
    for (int kill_number = 0; kill_number < kills; ++kill_number) {
        std::this_thread::sleep_for(std::chrono::milliseconds(random() % 60));
        Process& victim = processes[random() % workers];
        ASSERT_EQ(victim.killed(), 128 + SIGKILL) << "before kill " << kill_number;
        victim = Process([&] { return work(unsigned(100 + kill_number)); });
    }
    for (Process& process : processes) EXPECT_EQ(process.killed(), 128 + SIGKILL);

    // Every entry that can be seen is whole, whoever was killed.
    const std::vector<int> entries = kept(numbers);
    EXPECT_FALSE(entries.empty());
    const ContentCache cache = open(limit);
    for (const int n : entries) EXPECT_TRUE(fetches(cache, n, bytes_of_number(n))) << n;
    ASSERT_TRUE(store(cache, numbers));
    size_t bytes = 1000;
    for (const int n : kept(numbers - 1)) bytes += bytes_of_number(n);
    EXPECT_LE(bytes, size_t(limit));
    EXPECT_EQ(parts(), 0u);
}

TEST_F(ProcessesTest, ARaceForOneKeyIsWonByAll) {
    const ContentCache cache = open(limit);
    for (int round = 0; round < 20; ++round) {
        fs::remove_all(entry_of(7));
        std::vector<Process> processes;
        for (int i = 0; i < 5; ++i)
            processes.emplace_back([&] {
                return cache.store(key_of(7), baked(7)) &&
                               fetch_is_right(cache, 7, temporary_ / cat("into", getpid()))
                           ? 0
                           : 1;
            });
        for (Process& process : processes) EXPECT_EQ(process.exit_code(), 0);
        EXPECT_EQ(parts(), 0u);
    }
}

// A folder that is baked again and again has no report.json meanwhile; all files carry the number
// of the bake, and have a length of its own so that they cannot be taken for older ones.
TEST_F(ProcessesTest, AFolderThatChangesIsStoredWholeOrRefused) {
    const fs::path folder = temporary_ / "changing";
    const std::vector<std::string> names = {"a", "b", "report.json"};
    const auto bake_number = [&](int bake) {
        fs::remove(folder / "report.json");
        for (const std::string& name : names) {
            write_bytes(folder / (name + ".part"), cat(bake, std::string(size_t(bake), '.')));
            fs::rename(folder / (name + ".part"), folder / name);
        }
    };
    fs::create_directory(folder);
    Process baker([&] {
        for (int bake = 0;; bake = (bake + 1) % 5000) {
            bake_number(bake);
            std::this_thread::sleep_for(std::chrono::milliseconds(bake % 7 * 4));
        }
        return 0;
    });
    const ContentCache cache = open();
    int stored = 0, refused = 0;
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(2);
    for (int n = 0; std::chrono::steady_clock::now() < end; ++n) {
        const Status status = cache.store(key_of(n), folder, names);
        ++(status ? stored : refused);
        if (!status) {
            EXPECT_EQ(status.error().kind, ErrorKind::unreadable_input) << status.error().message;
            continue;
        }
        const TemporaryFolder into;
        ASSERT_TRUE(*cache.fetch(key_of(n), into.path()));
        EXPECT_EQ(bytes_of(into / "a"), bytes_of(into / "report.json"));
        EXPECT_EQ(bytes_of(into / "b"), bytes_of(into / "report.json"));
    }
    EXPECT_EQ(baker.killed(), 128 + SIGKILL);
    RecordProperty("stored", stored);
    RecordProperty("refused", refused);
    EXPECT_EQ(parts(), 0u);
}

// One process does nothing but remove entries from under the others.
TEST_F(ProcessesTest, WhoLosesTheEntryMidwayFindsNothing) {
    const ContentCache cache = open();
    Process evictor([&] {
        while (true) {
            const ContentCache strict = open(0);
            (void)strict.store(key_of(0), baked(0));
        }
        return 0;
    });
    int found = 0, absent = 0;
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(2);
    while (std::chrono::steady_clock::now() < end && (found < 50 || absent < 50)) {
        ASSERT_TRUE(cache.store(key_of(5), baked(5)));
        const TemporaryFolder into;
        const auto fetched = cache.fetch(key_of(5), into.path());
        ASSERT_TRUE(fetched) << fetched.error().message;
        if (*fetched)
            ASSERT_TRUE(files_in(into.path()) == files_of(5, bytes_of_number(5)));
        else
            ASSERT_TRUE(fs::is_empty(into.path()));
        ++(*fetched ? found : absent);
    }
    EXPECT_EQ(evictor.killed(), 128 + SIGKILL);
    EXPECT_GT(absent, 0);
}

}  // namespace
}  // namespace splitsum
