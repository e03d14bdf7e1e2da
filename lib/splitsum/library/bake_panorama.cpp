#include "splitsum/library/bake_panorama.h"

#include <optional>

#include "splitsum/bake/bake.h"
#include "splitsum/bake/recipe.h"
#include "splitsum/base/staged_folder.h"
#include "splitsum/base/text.h"
#include "splitsum/library/baked_report.h"
#include "splitsum/library/source_memory.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

// The file whose presence says that a folder is complete.
constexpr const char* last_file = "report.json";

// Without this note the next run reads the source again, which is no failure.
void remember(const fs::path& folder, const SourceStamp& stamp, const std::string& hash) {
    (void)remember_source(folder, stamp, hash);
}

// True: what the cache has of the job is in `folder`.
Result<bool> fetch(const LibraryJob& job, const fs::path& folder, BakeShop& shop,
                   LibraryItem& item) {
    const auto source = hash_of_source(job.panorama.file, folder);
    if (!source) return source.error();
    const auto recipe = recipe_of(job.panorama.file.filename().string(), source->hash, job.reading,
                                  job.plan, shop.configs);
    if (!recipe) return recipe.error();
    auto staged = StagedFolder::create(folder);
    if (!staged) return staged.error();
    const auto found = shop.cache->fetch(*recipe, staged->path());
    if (!found || !*found) return found;
    // What the cache holds is another's word; it counts if it says that it is what was asked for.
    const auto baked = read_baked_report(staged->path());
    if (!baked || baked->recipe != *recipe) return false;
    if (const Status published = staged->publish(last_file, drawn_files()); !published)
        return published.error();
    item.facts = facts_from(*baked);
    remember(folder, source->stamp, source->hash);
    return true;
}

// Bakes into a hidden folder first: the cache wants one that nobody else writes to.
Result<BakeReport> bake_and_store(const Light& light, const LibraryJob& job, const fs::path& folder,
                                  const ContentCache& cache, LibraryItem& item,
                                  Progress& progress) {
    auto staged = StagedFolder::create(folder);
    if (!staged) return staged.error();
    const auto report = bake(light, job.plan, staged->path(), progress);
    if (!report) return report.error();
    if (const Status stored = cache.store(report->recipe, staged->path()); !stored)
        item.notes.push_back(cat("not kept in the cache: ", stored.error().message));
    if (const Status published = staged->publish(last_file, drawn_files()); !published)
        return published.error();
    return report;
}

}  // namespace

Status bake_panorama(const LibraryJob& job, const fs::path& folder, BakeShop& shop,
                     LibraryItem& item, Progress& progress) {
    if (shop.cache) {
        const auto fetched = fetch(job, folder, shop, item);
        if (!fetched) return fetched.error();
        if (*fetched) {
            item.outcome = Outcome::from_cache;
            return ok;
        }
    }
    const auto stamp = stamp_of(job.panorama.file);
    if (!stamp) return stamp.error();
    const auto light =
        load_light(job.panorama.file, job.reading, light_use(job.plan, shop.tables), progress);
    if (!light) return light.error();
    const auto report = shop.cache
                            ? bake_and_store(*light, job, folder, *shop.cache, item, progress)
                            : bake(*light, job.plan, folder, progress);
    if (!report) return report.error();
    remember(folder, *stamp, report->source.hash);
    item.outcome = Outcome::baked;
    item.facts = facts_from(*report);
    item.notes.insert(item.notes.begin(), report->notes.begin(), report->notes.end());
    return ok;
}

}  // namespace splitsum
