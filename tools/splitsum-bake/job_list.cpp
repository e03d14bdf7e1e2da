#include "job_list.h"

#include <set>

#include "manifest_options.h"
#include "splitsum/base/text.h"
#include "splitsum/manifest/manifest.h"

namespace splitsum::tools {
namespace {

namespace fs = std::filesystem;

// The folders from `top` down to those of the panoramas: where a new panorama would be noticed.
void add_folders(const fs::path& top, std::span<const ListedPanorama> panoramas, JobList& list) {
    std::set<fs::path> folders = {top};
    for (const ListedPanorama& panorama : panoramas)
        for (fs::path folder = panorama.file.parent_path();
             folder != top && folder.has_parent_path() && folder != folder.parent_path();
             folder = folder.parent_path())
            folders.insert(folder);
    list.sources.insert(list.sources.end(), folders.begin(), folders.end());
}

// Lists one input, which may be a folder.
Result<std::vector<ListedPanorama>> list_input(const fs::path& input, const ListOptions& options,
                                               JobList& list) {
    auto panoramas = list_panoramas({input}, options);
    std::error_code failure;
    if (panoramas && fs::is_directory(input, failure)) add_folders(input, *panoramas, list);
    return panoramas;
}

void add_config(const PanoramaOptions& reading, JobList& list) {
    if (reading.ocio_config.empty()) return;
    if (std::ranges::find(list.sources, reading.ocio_config) == list.sources.end())
        list.sources.push_back(reading.ocio_config);
}

}  // namespace
