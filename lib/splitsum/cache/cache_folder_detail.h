#pragma once

#include <filesystem>

#include "splitsum/base/result.h"
#include "splitsum/cache/descriptor_detail.h"

namespace splitsum {

/// Opens a cache's folder, which a file CACHEDIR.TAG in it says to be one; that is also how backup
/// programs know to leave it out (bford.info/cachedir). An empty or missing folder becomes a cache.
/// Errors are those of ContentCache::open.
Result<Descriptor> open_cache_folder(const std::filesystem::path& folder);

}  // namespace splitsum
