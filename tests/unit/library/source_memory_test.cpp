#include "splitsum/library/source_memory.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>

#include "splitsum/base/file_hash.h"
#include "support/temporary_folder.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

class SourceMemory : public testing::Test {
protected:
    SourceMemory() { tests::write_bytes(source_, "radiance"); }

    /// As if the file had been there for long when it was looked at.
    SourceStamp old_stamp() const {
        SourceStamp stamp = *stamp_of(source_);
        stamp.asked_ns += 10'000'000'000;
        return stamp;
    }

    SourceHash look() const {
        const auto hash = hash_of_source(source_, folder_.path());
        EXPECT_TRUE(hash) << hash.error().message;
        return *hash;
    }

    tests::TemporaryFolder folder_;
    fs::path source_ = folder_ / "source.hdr";
};

TEST_F(SourceMemory, WithoutANoteTheFileIsRead) {
    const SourceHash hash = look();
    EXPECT_TRUE(hash.was_read);
    EXPECT_EQ(hash.hash, "xxh3-128:" + *hash_of_file(source_));
}

TEST_F(SourceMemory, AnUntouchedFileIsNotRead) {
    ASSERT_TRUE(remember_source(folder_.path(), old_stamp(), "a"));
    EXPECT_FALSE(look().was_read);
    EXPECT_EQ(look().hash, "a");
}

// Within the clock's step of being looked at, a file can change and look the same.
TEST_F(SourceMemory, AFileThatWasJustWrittenIsNotTrusted) {
    ASSERT_TRUE(remember_source(folder_.path(), *stamp_of(source_), "a"));
    EXPECT_TRUE(look().was_read);
}

TEST_F(SourceMemory, EveryChangeIsSeen) {
    const auto expect_seen_after = [&](const char* what, const auto& change) {
        tests::write_bytes(source_, "radiance");
        ASSERT_TRUE(remember_source(folder_.path(), old_stamp(), "a"));
        EXPECT_FALSE(look().was_read);
        change();
        EXPECT_TRUE(look().was_read) << what;
    };
    const auto modified = fs::last_write_time(source_);
    expect_seen_after("appended", [&] { std::ofstream(source_, std::ios::app) << "x"; });
    expect_seen_after("touched",
                      [&] { fs::last_write_time(source_, modified + std::chrono::hours(1)); });
    expect_seen_after("same size, time set back", [&] {
        const auto before = fs::last_write_time(source_);
        tests::write_bytes(source_, "RADIANCE");
        fs::last_write_time(source_, before);
    });
    expect_seen_after("another file, moved here", [&] {
        tests::write_bytes(folder_ / "other", "RADIANCE");
        fs::last_write_time(folder_ / "other", fs::last_write_time(source_));
        fs::rename(folder_ / "other", source_);
    });
}

TEST_F(SourceMemory, ADamagedNoteCostsAReading) {
    ASSERT_TRUE(remember_source(folder_.path(), old_stamp(), "a"));
    const std::string note = tests::bytes_of(folder_ / ".source");
    for (size_t size = 0; size + 1 < note.size(); ++size) {
        tests::write_bytes(folder_ / ".source", note.substr(0, size));
        EXPECT_TRUE(look().was_read) << note.substr(0, size);
    }
    tests::write_bytes(folder_ / ".source", "splitsum-source-2" + note.substr(17));
    EXPECT_TRUE(look().was_read);
    tests::write_bytes(folder_ / ".source", note);
    EXPECT_FALSE(look().was_read);
}

TEST_F(SourceMemory, AChangeWhileReadingIsAnError) {
    const auto before = stamp_of(source_);
    EXPECT_TRUE(check_unchanged(source_, *before));
    std::ofstream(source_, std::ios::app) << "more";
    const Status unchanged = check_unchanged(source_, *before);
    ASSERT_FALSE(unchanged);
    EXPECT_EQ(unchanged.error().kind, ErrorKind::unreadable_input);
    fs::remove(source_);
    EXPECT_FALSE(check_unchanged(source_, *before));
    EXPECT_FALSE(hash_of_source(source_, folder_.path()));
}

}  // namespace
}  // namespace splitsum
