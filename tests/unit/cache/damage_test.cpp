// Entries that are not what was stored count as absent, and nothing foreign is followed or removed.
#include <fstream>
#include <functional>

#include "unit/cache/entries.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;
using namespace tests;

using DamageTest = CacheTest;

void flip_bit(const fs::path& file, size_t place) {
    std::string bytes = bytes_of(file);
    bytes.at(place) = char(bytes[place] ^ 4);
    write_bytes(file, bytes);
}

// An entry that can be put back, which is faster than storing it again.
class IndexTest : public CacheTest {
protected:
    IndexTest() {
        EXPECT_TRUE(store(cache_, 1));
        fs::copy(entry_of(1), whole_);
    }

    /// Whether the entry is fetched with this text as its index; otherwise it must be gone.
    bool fetches_with(const std::string& index) {
        fs::remove_all(entry_of(1));
        fs::copy(whole_, entry_of(1));
        fs::remove(entry_of(1) / "index");  // a file that is made longer again is slow
        write_bytes(entry_of(1) / "index", index);
        const bool fetched = fetches(cache_, 1);
        EXPECT_EQ(fs::exists(entry_of(1)), fetched);
        return fetched;
    }

    const fs::path whole_ = temporary_ / "whole";
    const ContentCache cache_ = open();
};

TEST_F(IndexTest, EveryByteMatters) {
    const std::string index = bytes_of(whole_ / "index");
    EXPECT_TRUE(fetches_with(index));
    for (size_t place = 0; place < index.size(); ++place) {
        std::string changed = index;
        changed[place] = char(changed[place] ^ (1 << place % 7));
        EXPECT_FALSE(fetches_with(changed)) << place;
    }
    EXPECT_EQ(parts(), 0u);
}

TEST_F(IndexTest, NothingMayBeMissingOrFollow) {
    const std::string index = bytes_of(whole_ / "index");
    for (size_t size = 0; size < index.size(); ++size)
        EXPECT_FALSE(fetches_with(index.substr(0, size))) << size;
    for (const char* more : {"\n", "x", "index \n"}) EXPECT_FALSE(fetches_with(index + more));
}

TEST_F(DamageTest, ADamagedEntryCountsAsAbsentAndIsRemoved) {
    const std::vector<std::function<void(const fs::path&)>> damages = {
        [](const fs::path& entry) { flip_bit(entry / "1", 0); },
        [](const fs::path& entry) { flip_bit(entry / "2", 985); },
        [](const fs::path& entry) { fs::resize_file(entry / "2", 500); },
        [](const fs::path& entry) { fs::resize_file(entry / "2", int64_t(1) << 40); },
        [](const fs::path& entry) { fs::resize_file(entry / "0", 1); },
        [](const fs::path& entry) { fs::remove(entry / "0"); },
        [](const fs::path& entry) { fs::remove(entry / "index"); },
        [](const fs::path& entry) { fs::rename(entry / "1", entry / "0"); },
    };
    for (size_t i = 0; i < damages.size(); ++i) {
        const ContentCache cache = open();
        ASSERT_TRUE(store(cache, 1));
        ASSERT_TRUE(fetches(cache, 1));
        damages[i](entry_of(1));
        EXPECT_FALSE(fetches(cache, 1)) << i;
        EXPECT_FALSE(fs::exists(entry_of(1))) << i;
        EXPECT_EQ(parts(), 0u) << i;
    }
}

TEST_F(DamageTest, AnEntryUnderAnotherKeyIsNotThatEntry) {
    const ContentCache cache = open();
    ASSERT_TRUE(store(cache, 1));
    fs::create_directories(entry_of(2).parent_path());
    fs::copy(entry_of(1), entry_of(2));
    EXPECT_FALSE(fetches(cache, 2));
    EXPECT_TRUE(fetches(cache, 1));
}

// ---- what others put there

TEST_F(DamageTest, AForeignFileInAnEntryIsNeitherCopiedNorRemoved) {
    const ContentCache cache = open();
    ASSERT_TRUE(store(cache, 1));
    write_bytes(entry_of(1) / "notes.txt", "mine");
    fs::create_directory(entry_of(1) / "7");
    EXPECT_TRUE(fetches(cache, 1));
    flip_bit(entry_of(1) / "1", 0);
    EXPECT_FALSE(fetches(cache, 1));
    EXPECT_FALSE(fs::exists(entry_of(1)));
    const auto left = snapshot_of(cache_folder() / "parts");
    ASSERT_EQ(left.size(), 1u);
    EXPECT_EQ(left.begin()->second, "mine");
}

TEST_F(DamageTest, LinksLeadNowhere) {
    const fs::path outside = temporary_ / "outside";
    write_files(outside, files_of(1, 1000));
    fs::create_directories(outside / "parts" / key_of(1));
    const auto before = snapshot_of(outside);
    const auto link_instead = [&](const fs::path& path, const fs::path& target) {
        fs::remove_all(path);
        fs::create_symlink(target, path);
    };
    const fs::path entries = cache_folder() / "entries";
    for (const fs::path& replaced :
         {entry_of(1) / "2", entry_of(1) / "index", entry_of(1), entry_of(1).parent_path(), entries,
          cache_folder() / "parts"}) {
        {
            const ContentCache cache = open(4000);
            ASSERT_TRUE(store(cache, 1));
            link_instead(replaced,
                         replaced.filename() == "2" ? outside / "specular.ktx2" : outside);
            EXPECT_EQ(fetches(cache, 1), replaced.filename() == "parts") << replaced;
            for (int n = 1; n < 9; ++n) (void)store(cache, n);  // evicts, where it can
        }
        EXPECT_EQ(snapshot_of(outside), before) << replaced;
        fs::remove_all(cache_folder());
    }
}

TEST_F(DamageTest, APipeOrALongFileInPlaceOfAnIndexIsNoIndex) {
    const ContentCache cache = open();
    ASSERT_TRUE(store(cache, 1));
    ASSERT_TRUE(store(cache, 2));
    fs::remove(entry_of(1) / "index");
    ASSERT_EQ(mkfifo((entry_of(1) / "index").c_str(), 0600), 0);
    fs::resize_file(entry_of(2) / "index", int64_t(1) << 40);
    EXPECT_FALSE(fetches(cache, 1));
    EXPECT_FALSE(fetches(cache, 2));
}

TEST_F(DamageTest, OddNamesInTheFoldersOfTheCacheStay) {
    (void)open();
    const fs::path entries = cache_folder() / "entries";
    write_files(entries / "zz" / std::string(32, 'z'), {{"0", "mine"}});
    write_files(entries / "aa" / key_of(1), {{"0", "mine"}});  // begins with 1, not with aa
    write_files(cache_folder() / "parts" / "mine", {{"0", "mine"}});
    const ContentCache cache = open(1000);
    for (int n = 1; n < 5; ++n) ASSERT_TRUE(store(cache, n));
    EXPECT_TRUE(fs::exists(entries / "zz" / std::string(32, 'z') / "0"));
    EXPECT_TRUE(fs::exists(entries / "aa" / key_of(1) / "0"));
    EXPECT_TRUE(fs::exists(cache_folder() / "parts" / "mine" / "0"));
}

}  // namespace
}  // namespace splitsum
