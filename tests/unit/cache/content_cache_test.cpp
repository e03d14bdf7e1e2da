// Storing and fetching: what comes out is what went in, or nothing.
#include "splitsum/cache/content_cache.h"

#include <sys/resource.h>

#include <csignal>
#include <fstream>

#include "unit/cache/entries.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;
using namespace tests;

using ContentCacheTest = CacheTest;

TEST_F(ContentCacheTest, GivesBackWhatWasStored) {
    const ContentCache cache = open();
    EXPECT_FALSE(fetches(cache, 1));
    const Status stored = store(cache, 1, 3'000'000);  // more than one piece of a copy
    ASSERT_TRUE(stored) << stored.error().message;
    ASSERT_TRUE(store(cache, 17));
    EXPECT_TRUE(fetches(cache, 1, 3'000'000));
    EXPECT_TRUE(fetches(open(), 17));
    EXPECT_FALSE(fetches(cache, 2));
    EXPECT_EQ(parts(), 0u);
}

TEST_F(ContentCacheTest, TakesRecipesAsKeysAndNothingElse) {
    const ContentCache cache = open();
    ASSERT_TRUE(store(cache, 5));
    const TemporaryFolder into;
    const auto fetched = cache.fetch("xxh3-128:" + key_of(5), into.path());
    EXPECT_TRUE(fetched && *fetched);
    for (const std::string key : {"", "..", "xxh3-128:", "../../../../../../../../etc/passwd",
                                  "CCCCCCCCCCCCCCCCCCCCCCCCCCCCCCCC"}) {
        const auto refused = cache.fetch(key, into.path());
        ASSERT_FALSE(refused) << key;
        EXPECT_EQ(refused.error().kind, ErrorKind::bad_argument);
        EXPECT_FALSE(cache.store(key, into.path()));
    }
}

TEST_F(ContentCacheTest, KeepsTheNamedFilesOrAllThatAreNotHidden) {
    const ContentCache cache = open();
    const fs::path baked = temporary_ / "baked";
    write_files(baked, {{"a", "1"}, {"b", "2"}, {".source", "of this machine"}});
    write_files(baked / "another", {{"c", "3"}});
    const std::vector<std::string> names = {"b"};
    ASSERT_TRUE(cache.store(key_of(1), baked, names));
    ASSERT_TRUE(cache.store(key_of(2), baked));
    const TemporaryFolder one, two;
    ASSERT_TRUE(*cache.fetch(key_of(1), one.path()));
    ASSERT_TRUE(*cache.fetch(key_of(2), two.path()));
    EXPECT_EQ(files_in(one.path()), (std::map<std::string, std::string>{{"b", "2"}}));
    EXPECT_EQ(files_in(two.path()), (std::map<std::string, std::string>{{"a", "1"}, {"b", "2"}}));
}

TEST_F(ContentCacheTest, RefusesNamesThatAreNotThoseOfFilesInAFolder) {
    const ContentCache cache = open();
    const fs::path baked = temporary_ / "baked";
    write_files(baked, {{"a", "1"}});
    for (const std::string name : {"", ".", "..", "../baked/a", ".hidden", "two\nlines"}) {
        const Status refused = cache.store(key_of(1), baked, std::vector{name});
        ASSERT_FALSE(refused) << name;
        EXPECT_EQ(refused.error().kind, ErrorKind::bad_argument) << name;
    }
    EXPECT_FALSE(cache.store(key_of(1), baked, {}));
    const Status missing = cache.store(key_of(1), baked, std::vector<std::string>{"a", "b"});
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().kind, ErrorKind::unreadable_input);
    EXPECT_EQ(kept(1).size() + parts(), 0u);
}

TEST_F(ContentCacheTest, CopiesShareNothingWithTheCache) {
    const ContentCache cache = open();
    ASSERT_TRUE(store(cache, 1));
    const TemporaryFolder into;
    ASSERT_TRUE(*cache.fetch(key_of(1), into.path()));
    std::ofstream(into / "specular.ktx2", std::ios::in | std::ios::out) << "edited";
    EXPECT_TRUE(fetches(cache, 1));
}

TEST_F(ContentCacheTest, NeverWritesOverAFileAndLeavesTheFolderAsItWas) {
    const ContentCache cache = open();
    ASSERT_TRUE(store(cache, 1));
    const fs::path into = temporary_ / "into";
    write_files(into, {{"specular.ktx2", "mine"}});
    const auto refused = cache.fetch(key_of(1), into);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::unwritable_output);
    EXPECT_EQ(files_in(into), (std::map<std::string, std::string>{{"specular.ktx2", "mine"}}));
    EXPECT_FALSE(cache.fetch(key_of(1), temporary_ / "missing"));
    EXPECT_TRUE(fetches(cache, 1));
}

// What a full disk does, for any user: files may not grow over 512 bytes.
TEST_F(ContentCacheTest, AFullDiskLeavesNoTrace) {
    const ContentCache cache = open();
    ASSERT_TRUE(store(cache, 1));
    const fs::path into = temporary_ / "into";
    fs::create_directory(into);
    const fs::path baked = temporary_ / "baked";
    write_files(baked, files_of(2, 1000));
    const int code = in_a_process([&] {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{512, 512};
        setrlimit(RLIMIT_FSIZE, &limit);
        const auto fetched = cache.fetch(key_of(1), into);
        if (fetched || fetched.error().kind != ErrorKind::unwritable_output) return 1;
        const Status stored = cache.store(key_of(2), baked);
        return stored || stored.error().kind != ErrorKind::unwritable_output ? 2 : 0;
    });
    EXPECT_EQ(code, 0);
    EXPECT_TRUE(fs::is_empty(into));
    EXPECT_EQ(kept(3), std::vector{1});
    EXPECT_EQ(parts(), 0u);
    EXPECT_TRUE(fetches(cache, 1));
}

// Runs `run` as somebody who may not write to the cache; root may write anywhere.
template <class Run>
int without_permission(const fs::path& cache, const fs::path& room, const Run& run) {
    for (const auto& item : fs::recursive_directory_iterator(cache))
        fs::permissions(item, fs::perms::owner_write, fs::perm_options::remove);
    fs::permissions(cache, fs::perms::owner_write, fs::perm_options::remove);
    fs::permissions(room.parent_path(), fs::perms::group_exec | fs::perms::others_exec,
                    fs::perm_options::add);
    fs::permissions(room, fs::perms::all);
    const int code = in_a_process([&] {
        if (geteuid() == 0 && setuid(65534) != 0) return 99;
        return run();
    });
    fs::permissions(cache, fs::perms::owner_write, fs::perm_options::add);
    for (const auto& item : fs::recursive_directory_iterator(cache))
        fs::permissions(item, fs::perms::owner_write, fs::perm_options::add);
    return code;
}

TEST_F(ContentCacheTest, AReadOnlyCacheStillGivesAndSaysOnceThatItTakesNothing) {
    ASSERT_TRUE(store(open(), 1));
    const fs::path into = temporary_ / "into";
    write_files(into / "baked", {{"a", "1"}});
    const auto before = snapshot_of(cache_folder());
    const int code = without_permission(cache_folder(), into, [&] {
        const ContentCache cache = open();
        const auto fetched = cache.fetch(key_of(1), into);
        if (!fetched || !*fetched) return 1;
        const Status first = cache.store(key_of(2), into / "baked");
        if (first || first.error().kind != ErrorKind::unwritable_output) return 2;
        return cache.store(key_of(3), into / "baked") ? 0 : 3;
    });
    EXPECT_EQ(code, 0);
    EXPECT_EQ(snapshot_of(cache_folder()), before);
    fs::remove_all(into / "baked");
    EXPECT_TRUE(files_in(into) == files_of(1, 1000));
}

// ---- folders that are not caches

TEST_F(ContentCacheTest, RefusesAFolderWithOtherFilesAndTouchesNothing) {
    write_files(cache_folder(), {{"thesis.tex", "three years"}});
    const auto refused = ContentCache::open(cache_folder(), 1000);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::bad_argument);
    EXPECT_NE(refused.error().message.find("other kinds"), std::string::npos);
    EXPECT_EQ(files_in(cache_folder()).size(), 1u);
}

TEST_F(ContentCacheTest, RefusesCachesOfOthersAndOfOtherVersions) {
    const ContentCache ours = open();
    const fs::path tag = cache_folder() / "CACHEDIR.TAG";
    const std::string text = bytes_of(tag);
    const size_t version = text.find("version 1");
    ASSERT_NE(version, std::string::npos);
    for (const std::string& other :
         {std::string(text).replace(version, 9, "version 12"), text.substr(0, 43), std::string()}) {
        write_bytes(tag, other);
        const auto refused = ContentCache::open(cache_folder(), 1000);
        ASSERT_FALSE(refused) << other;
        EXPECT_EQ(refused.error().kind, ErrorKind::bad_argument);
    }
}

TEST_F(ContentCacheTest, ManyProcessesMayMakeItAtOnce) {
    for (int round = 0; round < 10; ++round) {
        std::vector<Process> children;
        for (int i = 0; i < 8; ++i)
            children.emplace_back(
                [&] { return ContentCache::open(temporary_ / cat("new", round), 1000) ? 0 : 1; });
        for (Process& child : children) EXPECT_EQ(child.exit_code(), 0);
    }
}

TEST_F(ContentCacheTest, ANegativeLimitIsRefused) {
    EXPECT_FALSE(ContentCache::open(cache_folder(), -1));
    EXPECT_FALSE(fs::exists(cache_folder()));
}

}  // namespace
}  // namespace splitsum
