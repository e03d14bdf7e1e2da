#include "splitsum/base/staged_folder.h"

#include <gtest/gtest.h>

#include "splitsum/base/atomic_file.h"
#include "support/temporary_folder.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

TEST(StagedFolder, FilesAppearWhenPublishedAndNotBefore) {
    const tests::TemporaryFolder temporary;
    const fs::path folder = temporary.path() / "a" / "b";
    {
        auto staged = StagedFolder::create(folder);
        ASSERT_TRUE(staged) << staged.error().message;
        ASSERT_TRUE(write_text_whole(staged->path() / "one", "1"));
        EXPECT_FALSE(fs::exists(folder / "one"));
        ASSERT_TRUE(staged->publish());
    }
    EXPECT_TRUE(fs::exists(folder / "one"));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1);
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

}  // namespace
}  // namespace splitsum
