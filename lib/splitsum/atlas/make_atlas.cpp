#include "splitsum/atlas/make_atlas.h"

#include <functional>
#include <utility>
#include <vector>

#include "splitsum/atlas/data_files.h"
#include "splitsum/atlas/entries.h"
#include "splitsum/atlas/light_cases.h"
#include "splitsum/atlas/page.h"
#include "splitsum/base/atomic_file.h"
#include "splitsum/base/staged_folder.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

// Hands cancellation down and keeps the stages of single filters to itself.
class Inner final : public Progress {
public:
    explicit Inner(const Progress& outer) : outer_(outer) {}
    void begin(std::string_view, int) override {}
    void advance(int) override {}
    bool cancelled() const override { return outer_.cancelled(); }

private:
    const Progress& outer_;
};

using MakeEntry = std::function<Result<AtlasEntry>(Progress& progress)>;

// The order of the page: light, tables, and what comes in and goes out.
std::vector<MakeEntry> entry_makers(const AtlasPlan& plan, const fs::path& scratch) {
    std::vector<MakeEntry> makers;
    for (LightCase& light : light_cases(plan))
        makers.push_back([&plan, light = std::move(light)](Progress& progress) {
            return light_entry(light, plan, progress);
        });
    for (const auto entry : {edges_entry, threads_entry, harmonics_entry, grazing_entry,
                             smooth_tables_entry, table_kinds_entry, formats_entry})
        makers.push_back([&plan, entry](Progress& progress) { return entry(plan, progress); });
    makers.push_back(
        [&plan, scratch](Progress& progress) { return files_entry(plan, scratch, progress); });
    return makers;
}

Status write_atlas(const Atlas& atlas, const fs::path& folder) {
    if (const Status written = write_text_whole(folder / "atlas.html", page_of(atlas)); !written)
        return written;
    if (const Status written = write_text_whole(folder / "atlas.json", json_of(atlas)); !written)
        return written;
    return write_text_whole(folder / "atlas.csv", csv_of(atlas));
}

}  // namespace

Result<Atlas> run_atlas(const AtlasPlan& plan, const fs::path& scratch, Progress& progress) {
    if (const Status valid = validate(plan); !valid) return valid.error();
    const std::vector<MakeEntry> makers = entry_makers(plan, scratch);
    progress.begin("atlas", static_cast<int>(makers.size()));
    Inner inner(progress);
    Atlas atlas{plan, {}};
    for (const MakeEntry& make : makers) {
        auto entry = make(inner);
        if (!entry) return entry.error();
        atlas.entries.push_back(std::move(*entry));
        progress.advance(1);
    }
    return atlas;
}

Result<Atlas> make_atlas(const AtlasPlan& plan, const fs::path& folder, Progress& progress) {
    auto staged = StagedFolder::create(folder);
    if (!staged) return staged.error();
    const fs::path scratch = staged->path() / "files";
    if (const Status made = make_folder(scratch); !made) return made.error();
    auto atlas = run_atlas(plan, scratch, progress);
    if (!atlas) return atlas.error();
    if (const Status written = write_atlas(*atlas, staged->path()); !written)
        return written.error();
    std::error_code failure;
    fs::remove_all(scratch, failure);
    if (const Status published = staged->publish("atlas.html"); !published)
        return published.error();
    return atlas;
}

}  // namespace splitsum
