#include "splitsum/cache/eviction_detail.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "splitsum/cache/entry_detail.h"
#include "splitsum/cache/part_folder_detail.h"

namespace splitsum {
namespace {

struct Candidate {
    std::string key;
    int64_t bytes;
    timespec used;

    bool operator<(const Candidate& other) const {
        return std::tie(used.tv_sec, used.tv_nsec, key) <
               std::tie(other.used.tv_sec, other.used.tv_nsec, other.key);
    }
};

void look_at_entry(const Descriptor& root, const Descriptor& shelf, const std::string& key,
                   std::vector<Candidate>& candidates) {
    const Descriptor entry = open_folder(shelf, key);
    if (!entry) return;
    const FoundIndex found = read_index(entry, key);
    struct stat about {};
    if (found.found == Found::whole &&
        fstatat(entry.get(), "index", &about, AT_SYMLINK_NOFOLLOW) == 0)
        candidates.push_back({key, found.index.bytes(), about.st_mtim});
    // It may just have been moved away by somebody else.
    if (found.found == Found::damaged && is_still(shelf, key, entry))
        discard_entry(root, shelf, key);
}

std::vector<Candidate> candidates_in(const Descriptor& root) {
    std::vector<Candidate> candidates;
    const Descriptor entries = open_folder(root, "entries");
    if (!entries) return candidates;
    for (const std::string& prefix : names_in(entries)) {
        const Descriptor shelf = open_folder(entries, prefix);
        if (!shelf) continue;
        for (const std::string& key : names_in(shelf))
            if (is_digits(key) && key.substr(0, 2) == prefix)
                look_at_entry(root, shelf, key, candidates);
    }
    return candidates;
}

int64_t sum_of_bytes(const std::vector<Candidate>& candidates) {
    int64_t sum = 0;
    for (const Candidate& candidate : candidates)
        sum += std::min(candidate.bytes, std::numeric_limits<int64_t>::max() - sum);
    return sum;
}

}  // namespace

int64_t evict(const Descriptor& root, int64_t most_bytes) {
    std::vector<Candidate> candidates = candidates_in(root);
    int64_t left = sum_of_bytes(candidates);
    if (left <= most_bytes) return left;
    std::ranges::sort(candidates, std::less<>());
    for (const Candidate& oldest : candidates) {
        // The last one stays wherever it can, even alone above the low water.
        const int64_t enough = &oldest == &candidates.back() ? most_bytes : low_water(most_bytes);
        if (left <= enough) break;
        const Descriptor shelf = open_shelf(root, oldest.key);
        if (shelf) discard_entry(root, shelf, oldest.key);
        left -= oldest.bytes;
    }
    return left;
}

}  // namespace splitsum
