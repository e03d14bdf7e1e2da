#include "splitsum/base/staged_folder.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <random>
#include <set>
#include <thread>
#include <vector>

#include "splitsum/base/atomic_file.h"
#include "splitsum/base/text.h"
#include "support/temporary_folder.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

std::set<std::string> names_in(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        names.insert(entry.path().filename().string());
    return names;
}

const std::vector<std::string> set_names = {"a_texture", "last", "z_texture"};

// Every file of the set says the same.
Status publish_set(const fs::path& folder, const std::string& text) {
    auto staged = StagedFolder::create(folder);
    if (!staged) return staged.error();
    for (const std::string& name : set_names)
        if (Status done = write_text_whole(staged->path() / name, text); !done) return done;
    return staged->publish("last");
}

void expect_one_set(const fs::path& folder) {
    for (const std::string& name : set_names)
        EXPECT_EQ(tests::bytes_of(folder / name), tests::bytes_of(folder / "last")) << name;
}

TEST(StagedFolder, FilesAppearWhenPublishedAndNotBefore) {
    const tests::TemporaryFolder temporary;
    const fs::path folder = temporary.path() / "a" / "b";
    {
        auto staged = StagedFolder::create(folder);
        ASSERT_TRUE(staged) << staged.error().message;
        ASSERT_TRUE(write_text_whole(staged->path() / "one", "1"));
        EXPECT_FALSE(fs::exists(folder / "one"));
        ASSERT_TRUE(staged->publish("one"));
    }
    EXPECT_EQ(names_in(folder), std::set<std::string>({"one"}));
}

TEST(StagedFolder, AFailureLeavesWhatWasThereBefore) {
    const tests::TemporaryFolder temporary;
    const fs::path older = temporary.path() / "a" / "older";
    ASSERT_TRUE(make_folder(older.parent_path()));
    ASSERT_TRUE(write_text_whole(older, "kept"));
    {
        auto staged = StagedFolder::create(temporary.path() / "a" / "b" / "c");
        ASSERT_TRUE(staged);
        ASSERT_TRUE(write_text_whole(staged->path() / "one", "1"));
    }
    EXPECT_TRUE(fs::exists(older));
    EXPECT_FALSE(fs::exists(temporary.path() / "a" / "b"));
}

TEST(StagedFolder, NeverRemovesWhatSomebodyElseWroteMeanwhile) {
    const tests::TemporaryFolder temporary;
    const fs::path folder = temporary.path() / "new";
    {
        auto staged = StagedFolder::create(folder);
        ASSERT_TRUE(staged);
        ASSERT_TRUE(write_text_whole(folder / "theirs", "x"));
    }
    EXPECT_TRUE(fs::exists(folder / "theirs"));
}

TEST(StagedFolder, ReplacesAnOlderSet) {
    const tests::TemporaryFolder folder;
    ASSERT_TRUE(publish_set(folder.path(), "older"));
    ASSERT_TRUE(write_text_whole(folder / "beside", "kept"));
    ASSERT_TRUE(publish_set(folder.path(), "newer"));
    for (const std::string& name : set_names)
        EXPECT_EQ(tests::bytes_of(folder / name), "newer") << name;
    EXPECT_EQ(tests::bytes_of(folder / "beside"), "kept");
    EXPECT_EQ(names_in(folder.path()).size(), 4u);
}

TEST(StagedFolder, WhatTheOlderSetHadMoreGoes) {
    const tests::TemporaryFolder folder;
    ASSERT_TRUE(publish_set(folder.path(), "older"));
    ASSERT_TRUE(write_text_whole(folder / "theirs", "kept"));
    auto staged = StagedFolder::create(folder.path());
    for (const char* name : {"a_texture", "last"})
        ASSERT_TRUE(write_text_whole(staged->path() / name, "newer"));
    ASSERT_TRUE(staged->publish("last", {"a_texture", "z_texture", "none"}));
    EXPECT_EQ(tests::bytes_of(folder / "a_texture"), "newer");
    EXPECT_FALSE(fs::exists(folder / "z_texture"));
    EXPECT_TRUE(fs::exists(folder / "theirs"));
}

// A staged folder cannot take the place of a file, which shows only in the middle of moving.
TEST(StagedFolder, PutsEverythingBackWhenAFileCannotBeMoved) {
    const tests::TemporaryFolder folder;
    for (const char* name : {"a", "b", "c", "last"})
        ASSERT_TRUE(write_text_whole(folder / name, cat("older ", name)));
    const auto before = tests::snapshot_of(folder.path());
    {
        auto staged = StagedFolder::create(folder.path());
        ASSERT_TRUE(staged);
        for (const char* name : {"a", "c", "last", "new"})
            ASSERT_TRUE(write_text_whole(staged->path() / name, "newer"));
        ASSERT_TRUE(make_folder(staged->path() / "b"));
        const Status published = staged->publish("last", {"gone"});
        ASSERT_FALSE(published);
        EXPECT_EQ(published.error().kind, ErrorKind::unwritable_output);
        EXPECT_NE(published.error().message.find((folder / "b").string()), std::string::npos)
            << published.error().message;
    }
    EXPECT_EQ(tests::snapshot_of(folder.path()), before);
    EXPECT_EQ(names_in(folder.path()).size(), 4u);
}

TEST(StagedFolder, WithoutTheLastFileNothingIsPublished) {
    const tests::TemporaryFolder folder;
    auto staged = StagedFolder::create(folder.path());
    ASSERT_TRUE(write_text_whole(staged->path() / "one", "1"));
    EXPECT_FALSE(staged->publish("report"));
    EXPECT_FALSE(fs::exists(folder / "one"));
}

TEST(StagedFolder, TwoThatStageAtOnceDoNotMeet) {
    const tests::TemporaryFolder folder;
    auto one = StagedFolder::create(folder.path());
    auto two = StagedFolder::create(folder.path());
    ASSERT_TRUE(one && two);
    EXPECT_NE(one->path(), two->path());
    EXPECT_TRUE(fs::exists(one->path())) << "taken for a leftover of the dead";
    ASSERT_TRUE(write_text_whole(one->path() / "x", "1"));
    ASSERT_TRUE(write_text_whole(two->path() / "x", "2"));
    EXPECT_TRUE(one->publish("x"));
    EXPECT_EQ(tests::bytes_of(folder / "x"), "1");
    EXPECT_TRUE(two->publish("x"));
    EXPECT_EQ(tests::bytes_of(folder / "x"), "2");
}

// Those that fail remove the folders they made, while others are about to use them.
TEST(StagedFolder, ManyAtOnceEndWithOneSet) {
    const tests::TemporaryFolder temporary;
    const fs::path folder = temporary.path() / "deep" / "er";
    constexpr int rounds = 40;
    std::atomic<int> published = 0;
    std::vector<std::string> failures(4);
    std::vector<std::thread> threads;
    for (int thread = 0; thread < 4; ++thread)
        threads.emplace_back([&, thread] {
            for (int round = 0; round < rounds; ++round) {
                if (round % 2 == thread % 2) {
                    const Status done = publish_set(folder, cat(thread, " ", round));
                    if (!done) failures[size_t(thread)] = done.error().message;
                    published += bool(done);
                    if (thread == 0 && round % 8 == 0) fs::remove(folder / "last");
                } else if (const auto given_up = StagedFolder::create(folder); !given_up) {
                    failures[size_t(thread)] = given_up.error().message;
                }
            }
        });
    for (std::thread& thread : threads) thread.join();
    for (const std::string& failure : failures) EXPECT_EQ(failure, "");
    EXPECT_EQ(published, 4 * rounds / 2);
    ASSERT_TRUE(publish_set(folder, "at the end"));
    expect_one_set(folder);
    EXPECT_EQ(names_in(folder).size(), set_names.size());
}

TEST(StagedFolder, FoldersMadeByThoseWhoFailDoNotHarmOthers) {
    const tests::TemporaryFolder temporary;
    const fs::path folder = temporary.path() / "deep" / "er";
    std::vector<std::thread> threads;
    std::atomic<int> failures = 0;
    for (int thread = 0; thread < 4; ++thread)
        threads.emplace_back([&] {
            for (int round = 0; round < 1500; ++round)
                if (const auto staged = StagedFolder::create(folder); !staged) ++failures;
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(failures, 0);
    // An empty folder may stay where the one who made it saw somebody else in it.
    EXPECT_TRUE(tests::snapshot_of(temporary.path()).empty());
}

// The child replaces the set over and over; a killed one may leave no `last`, never a wrong one.
TEST(StagedFolder, AKillAtAnyMomentLeavesNoMixtureUnderALastFile) {
    const tests::TemporaryFolder folder;
    const auto start = std::chrono::steady_clock::now();
    ASSERT_TRUE(publish_set(folder.path(), "at first"));
    const double one_round =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::mt19937 random(1);
    std::uniform_real_distribution<double> rounds(0, 3);
    int complete = 0, incomplete = 0;
    for (int kill_number = 0; kill_number < 60; ++kill_number) {
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child == 0)
            for (int round = 0;; ++round)
                if (!publish_set(folder.path(), cat(kill_number, " ", round))) _exit(1);
        std::this_thread::sleep_for(std::chrono::duration<double>(one_round * rounds(random)));
        kill(child, SIGKILL);
        int status = 0;
        waitpid(child, &status, 0);
        ASSERT_TRUE(WIFSIGNALED(status)) << "the child failed by itself";
        const bool is_complete = fs::exists(folder / "last");
        ++(is_complete ? complete : incomplete);
        if (!is_complete) continue;
        expect_one_set(folder.path());
    }
    // How many of each there are is up to the machine; both together prove something.
    RecordProperty("complete", complete);
    RecordProperty("incomplete", incomplete);
    std::printf("%d complete, %d incomplete after a kill\n", complete, incomplete);
    ASSERT_TRUE(publish_set(folder.path(), "at the end"));
    expect_one_set(folder.path());
    EXPECT_EQ(names_in(folder.path()).size(), set_names.size()) << "leftovers of the killed";
}

}  // namespace
}  // namespace splitsum
