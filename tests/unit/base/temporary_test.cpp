#include "splitsum/base/temporary.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <set>

#include "splitsum/base/atomic_file.h"
#include "splitsum/base/file_lock.h"
#include "support/temporary_folder.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

TEST(Temporary, NamesAreKnownAndNeverTheSame) {
    std::set<std::string> names;
    for (int i = 0; i < 1000; ++i) names.insert(temporary_name());
    EXPECT_EQ(names.size(), 1000u);
    for (const std::string& name : names) EXPECT_TRUE(is_temporary_name(name)) << name;
    for (const char* name : {"", ".part", "report.json", ".splitsum-.part",
                             ".splitsum-0123456789abcdeg.part", ".splitsum-0123456789abcdef.par"})
        EXPECT_FALSE(is_temporary_name(name)) << name;
}

// As after a kill: files and folders that nobody holds.
TEST(Temporary, LeftoversGoAndTheLivingStay) {
    const tests::TemporaryFolder folder;
    const fs::path dead_file = folder / temporary_name();
    const fs::path dead_folder = folder / temporary_name();
    const fs::path unlocked_folder = folder / temporary_name();
    tests::write_bytes(dead_file, "half");
    fs::create_directories(dead_folder / ".older");
    tests::write_bytes(dead_folder / lock_of_temporary, "");
    tests::write_bytes(dead_folder / "specular.ktx2", "half");
    fs::create_directory(unlocked_folder);
    tests::write_bytes(folder / ".splitsum-mine.part", "not ours");

    const fs::path living = folder / temporary_name();
    const auto held = FileLock::wait_for(living);
    ASSERT_TRUE(held);
    remove_leftovers(folder.path());
    for (const fs::path& gone : {dead_file, dead_folder, unlocked_folder})
        EXPECT_FALSE(fs::exists(gone)) << gone;
    EXPECT_TRUE(fs::exists(living));
    EXPECT_TRUE(fs::exists(folder / ".splitsum-mine.part"));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 2);
}

TEST(Temporary, AKilledWriterLeavesNothingForLong) {
    const tests::TemporaryFolder folder;
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        (void)write_file_whole(folder / "out", [](const fs::path& temporary) -> Status {
            tests::write_bytes(temporary, "half of it");
            kill(getpid(), SIGKILL);
            return ok;
        });
        _exit(1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
    ASSERT_TRUE(write_text_whole(folder / "other", "x"));
    EXPECT_FALSE(fs::exists(folder / "out"));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

TEST(FileLock, IsExclusiveUntilItIsLetGo) {
    const tests::TemporaryFolder folder;
    {
        const auto first = FileLock::try_now(folder / "lock");
        ASSERT_TRUE(first && *first);
        const auto second = FileLock::try_now(folder / "lock");
        ASSERT_TRUE(second);
        EXPECT_FALSE(*second);
    }
    const auto third = FileLock::try_now(folder / "lock");
    EXPECT_TRUE(third && *third);
}

TEST(FileLock, OfARemovedFileIsNoLock) {
    const tests::TemporaryFolder folder;
    const auto first = FileLock::wait_for(folder / "lock");
    ASSERT_TRUE(first);
    first->remove_file();
    const auto second = FileLock::try_now(folder / "lock");
    ASSERT_TRUE(second && *second);
    const auto third = FileLock::try_now(folder / "lock");
    ASSERT_TRUE(third);
    EXPECT_FALSE(*third);
}

TEST(FileLock, InAFolderThatIsMissingSaysSo) {
    const tests::TemporaryFolder folder;
    const auto lock = FileLock::wait_for(folder / "none" / "lock");
    ASSERT_FALSE(lock);
    EXPECT_EQ(lock.error().kind, ErrorKind::unwritable_output);
}

}  // namespace
}  // namespace splitsum
