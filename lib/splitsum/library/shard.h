#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "splitsum/base/result.h"
#include "splitsum/panorama/panorama.h"

namespace splitsum {

/// One of several parts of a library, each baked by a process of its own, on whatever machine.
struct Shard {
    int index = 1;  ///< in [1, count]
    int count = 1;
};

/// Reads "2/8". Fails with bad_argument.
Result<Shard> parse_shard(const std::string& text);

/// Which items of a list are the shard's, in the order of the list: every item is in exactly one of
/// the shards, all processes with equal lists agree which, and the sums of `pixels` are about equal.
/// The largest item goes first, to the shard with the least so far (Graham 1969, "Bounds on
/// Multiprocessing Timing Anomalies": never more than 4/3 of the best split); equals in the order of
/// the list.
std::vector<size_t> items_of(const Shard& shard, std::span<const int64_t> pixels);

/// The pixels of a panorama as its header says, 0 where it cannot be read: then its bake says why.
int64_t pixels_in(const std::filesystem::path& panorama, const PanoramaOptions& reading);

}  // namespace splitsum
