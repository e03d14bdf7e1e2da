#pragma once

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "splitsum/base/text.h"
#include "splitsum/cache/content_cache.h"
#include "support/temporary_folder.h"

namespace splitsum::tests {

/// The key number `n`; neighbours are in different folders, and 16 apart in the same.
inline std::string key_of(int n) {
    constexpr const char* digits = "0123456789abcdef";
    std::string key(32, 'c');
    key[0] = digits[n & 15];
    for (int i = 31; n > 0; n >>= 4) key[size_t(i--)] = digits[n & 15];
    return key;
}

/// What a baked folder of this number holds: several files, lopsided in size, one of them empty.
inline std::map<std::string, std::string> files_of(int n, size_t bytes) {
    std::string large(bytes - 14, '\0');
    uint32_t state = uint32_t(n) * 2654435761u + 1;
    for (char& letter : large) letter = char((state = state * 1664525u + 1013904223u) >> 24);
    return {{"specular.ktx2", large},
            {"report.json", cat("{\"number\": ", 100 + n, '}').substr(0, 14)},
            {"a name, with blanks", ""}};
}

inline void write_files(const std::filesystem::path& folder,
                        const std::map<std::string, std::string>& files) {
    std::filesystem::create_directories(folder);
    for (const auto& [name, bytes] : files) write_bytes(folder / name, bytes);
}

/// Names and bytes of everything in a flat folder.
inline std::map<std::string, std::string> files_in(const std::filesystem::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& [path, bytes] : snapshot_of(folder))
        files[std::filesystem::relative(path, folder).string()] = bytes;
    return files;
}

/// A process that ends with what `run` returns, which may not report failures in another way. It is
/// killed with the object if it still runs.
class Process {
public:
    template <class Run>
    explicit Process(const Run& run) : id_(fork()) {
        if (id_ != 0) return;
        try {
            _exit(run());
        } catch (const std::exception& error) {
            fprintf(stderr, "%s\n", error.what());
            _exit(98);
        }
    }
    Process(Process&& other) noexcept : id_(std::exchange(other.id_, -1)) {}
    Process& operator=(Process&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }
    ~Process() { (void)killed(); }

    /// Waits for the end: the exit code, or 128 + the signal that ended it.
    int exit_code() {
        int status = 0;
        waitpid(std::exchange(id_, -1), &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }

    /// The same after SIGKILL.
    int killed() {
        if (id_ <= 0) return -1;
        kill(id_, SIGKILL);
        return exit_code();
    }

private:
    pid_t id_;
};

template <class Run>
int in_a_process(const Run& run) {
    return Process(run).exit_code();
}

/// A cache in a folder that goes with the object, and room beside it.
class CacheTest : public testing::Test {
protected:
    std::filesystem::path cache_folder() const { return temporary_ / "cache"; }
    std::filesystem::path entry_of(int n) const {
        return cache_folder() / "entries" / key_of(n).substr(0, 2) / key_of(n);
    }

    ContentCache open(int64_t most_bytes = int64_t(1) << 40) const {
        auto cache = ContentCache::open(cache_folder(), most_bytes);
        if (!cache) throw std::runtime_error(cache.error().message);
        return std::move(*cache);
    }

    /// Stores the files of number `n`.
    Status store(const ContentCache& cache, int n, size_t bytes = 1000) const {
        const TemporaryFolder baked;
        write_files(baked.path(), files_of(n, bytes));
        return cache.store(key_of(n), baked.path());
    }

    /// Whether the cache has number `n`; then its files must be the right ones, else none.
    bool fetches(const ContentCache& cache, int n, size_t bytes = 1000) const {
        const TemporaryFolder into;
        const auto found = cache.fetch(key_of(n), into.path());
        EXPECT_TRUE(found) << found.error().message;
        if (!found) return false;
        // Not EXPECT_EQ, which would print all bytes.
        if (*found)
            EXPECT_TRUE(files_in(into.path()) == files_of(n, bytes)) << "wrong files of " << n;
        else
            EXPECT_TRUE(std::filesystem::is_empty(into.path())) << "leftovers of " << n;
        return *found;
    }

    /// The numbers up to `most` that the cache has, without using them.
    std::vector<int> kept(int most) const {
        std::vector<int> numbers;
        for (int n = 0; n <= most; ++n)
            if (std::filesystem::exists(entry_of(n))) numbers.push_back(n);
        return numbers;
    }

    size_t parts() const {
        const auto folder = cache_folder() / "parts";
        if (!std::filesystem::exists(folder)) return 0;
        return size_t(std::distance(std::filesystem::directory_iterator(folder), {}));
    }

    TemporaryFolder temporary_;
};

}  // namespace splitsum::tests
