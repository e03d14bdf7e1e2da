#include "splitsum/base/file_hash.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "splitsum/base/atomic_file.h"

namespace splitsum {
namespace {

TEST(FileHash, IsWhatXxhsumPrints) {
    const auto path = std::filesystem::path(testing::TempDir()) / "hash_me";
    ASSERT_TRUE(write_text_whole(path, "splitsum"));
    const auto hash = hash_of_file(path);
    ASSERT_TRUE(hash) << hash.error().message;
    EXPECT_EQ(*hash, "248e2a84df1dcb2b7b77c42813e58ab3");
}

TEST(FileHash, NamesAMissingFile) {
    const auto hash = hash_of_file("no/such/file");
    ASSERT_FALSE(hash);
    EXPECT_EQ(hash.error().kind, ErrorKind::unreadable_input);
    EXPECT_NE(hash.error().message.find("no/such/file"), std::string::npos);
}

}  // namespace
}  // namespace splitsum
