// A run over a library: who is told what, what stops it, and what a stopped run leaves.
#include "splitsum/library/bake_library.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <set>

#include "splitsum/base/temporary.h"
#include "splitsum/library/merge.h"
#include "support/temporary_folder.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;
using tests::TemporaryFolder;

// Remembers who was told what, and may do something about it.
class Notes final : public LibraryObserver {
public:
    void begun(std::span<const size_t> jobs) override { shard.assign(jobs.begin(), jobs.end()); }
    void planned(std::span<const size_t> jobs, std::span<const int64_t> sizes) override {
        stale.assign(jobs.begin(), jobs.end());
        pixels.assign(sizes.begin(), sizes.end());
    }
    void started(size_t job) override { begun_jobs.push_back(job); }
    void finished(const LibraryItem& item) override {
        settled.push_back(item.job);
        if (on_finished) on_finished();
    }

    std::vector<size_t> shard, stale, begun_jobs, settled;
    std::vector<int64_t> pixels;
    std::function<void()> on_finished;
};

class Switch final : public Progress {
public:
    void begin(std::string_view, int) override {}
    void advance(int) override {}
    bool cancelled() const override { return off; }
    std::atomic<bool> off = false;
};

class BakeLibrary : public testing::Test {
protected:
    BakeLibrary() {
        for (int i = 0; i < 5; ++i) add(i, i == 2 ? 32 : 8);
        run_.folder = folder_ / "out";
        run_.table.plan.size = 8;
        run_.threads = 2;
    }

    // A sky of its own; the job that bakes it.
    void add(int seed, int height) {
        std::string bytes =
            "PF\n" + std::to_string(2 * height) + " " + std::to_string(height) + "\n-1.0\n";
        for (int i = 0; i < 2 * height * height * 3; ++i) {
            const float value = 0.25f + float((i * (seed + 3)) % 11);
            bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
        }
        const std::string name = "sky" + std::to_string(seed);
        const fs::path file = folder_ / (name + ".pfm");
        tests::write_bytes(file, bytes);
        BakePlan plan;
        plan.specular.face_size = 8;
        plan.specular.levels = 2;
        plan.irradiance.face_size = 4;
        plan.probes = 2;
        plan.picture = false;
        LibraryJob job;
        job.panorama = {file, name};
        job.plan = plan;
        jobs_.push_back(job);
    }

    LibrarySummary bake() {
        const auto summary = bake_library(jobs_, run_, notes_, progress_);
        EXPECT_TRUE(summary) << summary.error().message;
        return summary ? *summary : LibrarySummary{};
    }
    std::vector<Outcome> outcomes(const LibrarySummary& summary) const {
        std::vector<Outcome> found;
        for (const LibraryItem& item : summary.items) found.push_back(item.outcome);
        return found;
    }

    TemporaryFolder folder_;
    std::vector<LibraryJob> jobs_;
    LibraryRun run_;
    Notes notes_;
    Switch progress_;
};

TEST_F(BakeLibrary, TellsWhatGoesOn) {
    const auto summary = bake();
    EXPECT_EQ(outcomes(summary), std::vector(5, Outcome::baked));
    EXPECT_EQ(notes_.shard, (std::vector<size_t>{0, 1, 2, 3, 4}));
    EXPECT_EQ(notes_.stale, notes_.shard);
    EXPECT_EQ(notes_.pixels, (std::vector<int64_t>{128, 128, 2048, 128, 128}));
    EXPECT_EQ(notes_.begun_jobs.size(), 5u);
    EXPECT_EQ(std::set(notes_.settled.begin(), notes_.settled.end()).size(), 5u);
    ASSERT_TRUE(summary.table);
    EXPECT_EQ(summary.table->outcome, Outcome::baked);
    for (const LibraryItem& item : summary.items) {
        EXPECT_FALSE(item.why.empty());
        ASSERT_TRUE(item.facts);
        EXPECT_EQ(item.facts->files.size(), 3u);
        EXPECT_GT(bytes_of(*item.facts), 0);
    }
    const auto check = check_merged(jobs_, run_.table, run_.folder, progress_);
    ASSERT_TRUE(check);
    EXPECT_TRUE(check->holds());
    EXPECT_EQ(check->complete, 5u);
    EXPECT_EQ(check->worst_rel_rms, summary.items[check->worst].facts->worst_rel_rms);
}

TEST_F(BakeLibrary, FindsTheSameFactsAgain) {
    const auto first = bake();
    const auto second = bake();
    EXPECT_EQ(outcomes(second), std::vector(5, Outcome::up_to_date));
    EXPECT_EQ(second.table->outcome, Outcome::up_to_date);
    // The file has three digits of it.
    EXPECT_NEAR(second.table->max_abs, first.table->max_abs, 5e-3 * first.table->max_abs);
    EXPECT_TRUE(notes_.stale.empty());
    for (size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(bytes_of(*second.items[i].facts), bytes_of(*first.items[i].facts));
        EXPECT_EQ(second.items[i].facts->worst_rel_rms, first.items[i].facts->worst_rel_rms);
    }
}

TEST_F(BakeLibrary, BeginsNothingAfterItIsCancelled) {
    run_.threads = 1;
    notes_.on_finished = [this] { progress_.off = true; };
    const auto stopped = bake();
    ASSERT_TRUE(stopped.stopped);
    EXPECT_EQ(stopped.stopped->kind, ErrorKind::interrupted);
    EXPECT_EQ(std::ranges::count(outcomes(stopped), Outcome::baked), 1);
    EXPECT_EQ(std::ranges::count(outcomes(stopped), Outcome::not_begun), 4);
    EXPECT_EQ(notes_.begun_jobs, (std::vector<size_t>{2}));  // the largest begins
    progress_.off = false;
    notes_.on_finished = nullptr;
    const auto rest = bake();
    EXPECT_FALSE(rest.stopped);
    EXPECT_EQ(std::ranges::count(outcomes(rest), Outcome::up_to_date), 1);
    EXPECT_EQ(std::ranges::count(outcomes(rest), Outcome::baked), 4);
}

// As when one of two was killed, and the other has completed the library since.
TEST_F(BakeLibrary, RemovesWhatTheKilledLeftWhereAllIsUpToDate) {
    bake();
    const std::vector<fs::path> leftovers = {run_.folder / temporary_name(),
                                             run_.folder / "sky1" / temporary_name()};
    for (const fs::path& file : leftovers) tests::write_bytes(file, "half a table");
    run_.dry_run = true;
    bake();
    for (const fs::path& file : leftovers)
        EXPECT_TRUE(fs::exists(file)) << "dry runs write nothing";
    run_.dry_run = false;
    EXPECT_EQ(outcomes(bake()), std::vector(5, Outcome::up_to_date));
    for (const fs::path& file : leftovers) EXPECT_FALSE(fs::exists(file)) << file;
}

// What comes too late changes nothing.
TEST_F(BakeLibrary, IsDoneWhereNothingIsLeftToStop) {
    bake();
    int left = 5;
    notes_.on_finished = [&] { progress_.off = --left == 0; };
    EXPECT_FALSE(bake().stopped);
}

TEST_F(BakeLibrary, StopsForATableThatCannotBeMade) {
    run_.threads = 1;
    run_.table.plan.accuracy = 1e-7;  // half floats cannot
    const auto summary = bake();
    ASSERT_TRUE(summary.stopped);
    EXPECT_EQ(summary.stopped->kind, ErrorKind::bad_argument);
    EXPECT_EQ(std::ranges::count(outcomes(summary), Outcome::baked), 1);
}

TEST_F(BakeLibrary, LeavesTheRestToOtherShards) {
    run_.shard = {2, 2};
    const auto second = bake();
    EXPECT_LT(second.items.size(), 5u);
    const auto half = check_merged(jobs_, run_.table, run_.folder, progress_);
    ASSERT_TRUE(half);
    EXPECT_FALSE(half->holds());
    EXPECT_EQ(half->complete, second.items.size());
    EXPECT_EQ(half->problems.size(), 5 - second.items.size());
    run_.shard = {3, 2};
    const auto none = bake_library(jobs_, run_, notes_, progress_);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().kind, ErrorKind::bad_argument);
}

TEST_F(BakeLibrary, RefusesTwoOfOneNameBeforeItWrites) {
    jobs_[3].panorama.name = jobs_[1].panorama.name;
    const auto refused = bake_library(jobs_, run_, notes_, progress_);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::bad_argument);
    EXPECT_FALSE(fs::exists(run_.folder));
    EXPECT_TRUE(notes_.shard.empty());
}

TEST_F(BakeLibrary, FailsWhatDoesNotFitIntoMemory) {
    run_.memory = 1000;
    const auto summary = bake();
    EXPECT_EQ(outcomes(summary), std::vector(5, Outcome::failed));
    EXPECT_FALSE(summary.stopped);
    EXPECT_FALSE(fs::exists(run_.folder));
}

}  // namespace
}  // namespace splitsum
