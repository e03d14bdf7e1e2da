#pragma once

#include <filesystem>
#include <memory>

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/library/bake_library.h"

namespace splitsum {

/// What the bakes of a run share.
struct BakeShop {
    const ContentCache* cache = nullptr;
    std::shared_ptr<FilterTables> tables = std::make_shared<FilterTables>();
    ConfigHashes configs{};
};

/// Fills `folder` with what the job makes: from the cache where it has it, else by baking, after
/// which the cache gets a copy. The files appear together or not at all. Sets outcome, facts and
/// notes of the item; a cache that cannot be written to is a note. Remembers the source in the folder.
///
/// Fails as load_light and bake do.
Status bake_panorama(const LibraryJob& job, const std::filesystem::path& folder, BakeShop& shop,
                     LibraryItem& item, Progress& progress);

}  // namespace splitsum
